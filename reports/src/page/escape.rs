//! Text from files, made safe to stand in HTML, SVG or a shell command.
//!
//! Every string that was read from a file passes through here before it reaches the page.

/// `raw` as text or attribute value of HTML and XML.
///
/// Characters that XML forbids become U+FFFD: one of them would make a browser refuse the whole picture.
pub fn text(raw: &str) -> String {
    let mut safe = String::with_capacity(raw.len());
    for c in raw.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\t' | '\n' | '\r' => safe.push(' '),
            c if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') => safe.push('\u{FFFD}'),
            c => safe.push(c),
        }
    }
    safe
}

/// `raw` as one word of a POSIX shell command, quoted where it must be. Not yet safe for HTML.
pub fn shell(raw: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:+=@%,".contains(c);
    if !raw.is_empty() && raw.chars().all(plain) { raw.to_owned() } else { format!("'{}'", raw.replace('\'', r"'\''")) }
}

/// The filter term of the page that selects rows whose `column` is exactly `value`. Not yet safe for HTML.
pub fn filter(column: &str, value: &str) -> String {
    format!("{column}=\"{}\"", value.replace('"', "\"\""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn markup_is_disarmed() {
        assert_eq!(text("<script>alert('1' & \"2\")"), "&lt;script&gt;alert(&#39;1&#39; &amp; &quot;2&quot;)");
        assert_eq!(text("a\u{0}b\u{1b}c\u{FFFF}"), "a\u{FFFD}b\u{FFFD}c\u{FFFD}");
    }

    #[test]
    fn shell_words_hold_together() {
        assert_eq!(shell("gears/4-7.json"), "gears/4-7.json");
        assert_eq!(shell("it's; rm"), r"'it'\''s; rm'");
        assert_eq!(shell(""), "''");
    }

    #[test]
    fn filter_doubles_quotes() {
        assert_eq!(filter("case", "a \"b\""), "case=\"a \"\"b\"\"\"");
    }

    proptest! {
        #[test]
        fn nothing_active_survives(raw in any::<String>()) {
            let safe = text(&raw);
            prop_assert!(!safe.contains(['<', '>', '"', '\'']));
            prop_assert!(!safe.chars().any(char::is_control));
        }
    }
}
