//! As much of Rust's grammar as the rules need: words, paths, and where the tests begin.

/// A word, `::`, or one other character, with its line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    pub text: String,
    pub line: usize,
}

/// The words and signs of a source text, without comments, strings and characters.
pub fn tokens(source: &str) -> Vec<Token> {
    let chars: Vec<char> = source.chars().collect();
    let mut out: Vec<Token> = Vec::new();
    let (mut i, mut line) = (0, 1);
    while i < chars.len() {
        let start = i;
        let rest = &chars[i..];
        let c = rest[0];
        if rest.starts_with(&['/', '/']) {
            i += rest.iter().position(|c| *c == '\n').unwrap_or(rest.len());
        } else if rest.starts_with(&['/', '*']) {
            i += block_comment(rest);
        } else if let Some(length) = raw_string(rest) {
            i += length;
        } else if c == '"' {
            i += quoted(rest, '"');
        } else if c == '\'' {
            // 'a' and '\n' are characters, 'a is a lifetime.
            let is_char = rest.get(1) == Some(&'\\') || rest.get(2) == Some(&'\'');
            i += if is_char { quoted(rest, '\'') } else { 1 };
        } else if c.is_alphanumeric() || c == '_' {
            i += rest
                .iter()
                .position(|c| !c.is_alphanumeric() && *c != '_')
                .unwrap_or(rest.len());
            let text = chars[start..i].iter().collect();
            out.push(Token { text, line });
        } else {
            let pair = rest.starts_with(&[':', ':']);
            i += if pair { 2 } else { 1 };
            if !c.is_whitespace() {
                let text = chars[start..i].iter().collect();
                out.push(Token { text, line });
            }
        }
        line += chars[start..i].iter().filter(|c| **c == '\n').count();
    }
    out
}

fn block_comment(rest: &[char]) -> usize {
    let (mut depth, mut i) = (0, 0);
    while i < rest.len() {
        if rest[i..].starts_with(&['/', '*']) {
            depth += 1;
            i += 2;
        } else if rest[i..].starts_with(&['*', '/']) {
            depth -= 1;
            i += 2;
            if depth == 0 {
                break;
            }
        } else {
            i += 1;
        }
    }
    i
}

fn raw_string(rest: &[char]) -> Option<usize> {
    let open = rest.strip_prefix(&['r'])?;
    let hashes = open.iter().take_while(|c| **c == '#').count();
    if open.get(hashes) != Some(&'"') {
        return None;
    }
    let mut close = vec!['"'];
    close.resize(hashes + 1, '#');
    let body = 2 + hashes;
    let length = rest[body..]
        .windows(close.len())
        .position(|window| window == close);
    Some(length.map_or(rest.len(), |length| body + length + close.len()))
}

fn quoted(rest: &[char], quote: char) -> usize {
    let mut i = 1;
    while i < rest.len() && rest[i] != quote {
        i += if rest[i] == '\\' { 2 } else { 1 };
    }
    (i + 1).min(rest.len())
}

/// A path as written, its groups unfolded, with the inline modules around it.
#[derive(Debug, PartialEq, Eq)]
pub struct WrittenPath {
    pub segments: Vec<String>,
    pub inside: Vec<String>,
    pub line: usize,
}

/// Every path of at least two words, and every word behind `use`.
pub fn paths(tokens: &[Token]) -> Vec<WrittenPath> {
    let text = |i: usize| {
        tokens
            .get(i)
            .map_or("", |token: &Token| token.text.as_str())
    };
    let mut out = Vec::new();
    let mut inside: Vec<(String, usize)> = Vec::new();
    let (mut i, mut depth) = (0, 0_usize);
    while i < tokens.len() {
        match text(i) {
            "{" => depth += 1,
            "}" => {
                depth = depth.saturating_sub(1);
                inside.retain(|(_, opened)| *opened < depth + 1);
            }
            "mod" if text(i + 2) == "{" => inside.push((text(i + 1).to_owned(), depth + 1)),
            _ => {}
        }
        let starts = is_word(text(i)) && text(i) != "use";
        if starts && (text(i + 1) == "::" || (i > 0 && text(i - 1) == "use")) {
            let names: Vec<String> = inside.iter().map(|(name, _)| name.clone()).collect();
            let from = out.len();
            i = unfold(tokens, i, &[], &mut out);
            for path in &mut out[from..] {
                path.inside.clone_from(&names);
            }
        } else {
            i += 1;
        }
    }
    out
}

fn is_word(text: &str) -> bool {
    text.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Reads one path or one branch of a group from `i`, and returns where it ends.
fn unfold(tokens: &[Token], mut i: usize, prefix: &[String], out: &mut Vec<WrittenPath>) -> usize {
    let text = |i: usize| {
        tokens
            .get(i)
            .map_or("", |token: &Token| token.text.as_str())
    };
    let line = tokens.get(i).map_or(0, |token| token.line);
    let mut segments = prefix.to_vec();
    while is_word(text(i)) {
        segments.push(text(i).to_owned());
        i += 1;
        if text(i) != "::" {
            break;
        }
        i += 1;
        if text(i) == "{" {
            i += 1;
            while i < tokens.len() && text(i) != "}" {
                let before = i;
                i = unfold(tokens, i, &segments, out);
                // A star, a comma, `as name`: on to the next branch.
                while i < tokens.len() && text(i) != "," && text(i) != "}" {
                    i += 1;
                }
                if text(i) == "," {
                    i += 1;
                }
                debug_assert!(i > before);
            }
            return i + 1;
        }
    }
    out.push(WrittenPath {
        segments,
        inside: Vec::new(),
        line,
    });
    i
}

/// The tokens without items behind `#[cfg(test)]`.
pub fn without_tests(tokens: &[Token]) -> Vec<Token> {
    let mark = ["#", "[", "cfg", "(", "test", ")", "]"];
    let mut out = Vec::new();
    let mut i = 0;
    while i < tokens.len() {
        let marked = tokens[i..]
            .iter()
            .map(|token| token.text.as_str())
            .take(mark.len())
            .eq(mark);
        if !marked {
            out.push(tokens[i].clone());
            i += 1;
            continue;
        }
        let mut depth = 0;
        while i < tokens.len() {
            let text = tokens[i].text.as_str();
            i += 1;
            match text {
                "{" => depth += 1,
                "}" => depth -= 1,
                _ => {}
            }
            if depth == 0 && (text == "}" || text == ";") {
                break;
            }
        }
    }
    out
}

#[test]
fn paths_are_read_as_written() {
    let text = "use crate::{a::B, c::{self, D as E}, f::*};\n// crate::no\nmod m { fn g<'a>(x: &'a str) {\n\
                let c = '\\''; super::h::<u8>(\"crate::no\", r#\"crate::\"no\"#); } }\nuse x;\nuse ::y::Z;";
    let read: Vec<(String, usize, usize)> = paths(&tokens(text))
        .into_iter()
        .map(|path| (path.segments.join("::"), path.inside.len(), path.line))
        .collect();
    let expected = [
        ("crate::a::B", 0, 1),
        ("crate::c::self", 0, 1),
        ("crate::c::D", 0, 1),
        ("crate::f", 0, 1),
        ("super::h", 1, 4),
        ("x", 0, 5),
        ("y::Z", 0, 6),
    ];
    let expected: Vec<_> = expected
        .map(|(path, inside, line)| (path.to_owned(), inside, line))
        .into();
    assert_eq!(read, expected);
}

#[test]
fn what_only_tests_use_is_left_out() {
    let text =
        "fn a() {}\n#[cfg(test)]\nmod tests { fn b() { { } } }\n#[cfg(test)] mod far;\nfn c() {}";
    let words: Vec<String> = without_tests(&tokens(text))
        .into_iter()
        .map(|t| t.text)
        .collect();
    assert_eq!(words.join(" "), "fn a ( ) { } fn c ( ) { }");
}
