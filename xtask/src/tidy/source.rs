//! Rust text as the rules see it: without comments, strings and unit tests, and with line numbers kept.

/// The code of a source file: comments, string and character literals and `#[cfg(test)]` items are blanked, line ends stay.
pub(super) fn code(text: &str) -> String {
    without_unit_tests(without_comments(text))
}

fn without_comments(text: &str) -> String {
    let chars: Vec<char> = text.chars().collect();
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    while at < chars.len() {
        let end = skip_one(&chars, at);
        if end == at {
            out.push(chars[at]);
            at += 1;
        } else {
            out.extend(chars[at..end].iter().map(|&c| if c == '\n' { '\n' } else { ' ' }));
            at = end;
        }
    }
    out
}

/// The end of the comment or literal that starts at `at`, or `at` itself if none does.
fn skip_one(chars: &[char], at: usize) -> usize {
    let next = |k: usize| chars.get(at + k).copied().unwrap_or('\0');
    let inside_word = at > 0 && is_word(chars[at - 1]);
    match chars[at] {
        '/' if next(1) == '/' => find(chars, at, |i| chars[i] == '\n'),
        '/' if next(1) == '*' => {
            let mut depth = 0_usize;
            let mut i = at;
            while i < chars.len() {
                match (chars[i], chars.get(i + 1)) {
                    ('/', Some('*')) => (depth, i) = (depth + 1, i + 2),
                    ('*', Some('/')) => (depth, i) = (depth - 1, i + 2),
                    _ => i += 1,
                }
                if depth == 0 {
                    return i;
                }
            }
            i
        }
        '"' => end_of_string(chars, at + 1, '"'),
        // Raw strings, also with a `b` or `c` before the `r` (which is then left standing).
        'r' if !inside_word || matches!(chars[at - 1], 'b' | 'c') => {
            let hashes = chars[at + 1..].iter().take_while(|&&c| c == '#').count();
            if next(1 + hashes) != '"' {
                return at;
            }
            let closes = |i: usize| {
                chars[i] == '"' && chars[i + 1..].iter().take(hashes).filter(|&&c| c == '#').count() == hashes
            };
            (find(chars, at + 2 + hashes, closes) + 1 + hashes).min(chars.len())
        }
        // A character, not a lifetime: 'x' or an escape.
        '\'' if next(1) == '\\' || (next(2) == '\'' && next(1) != '\'') => end_of_string(chars, at + 1, '\''),
        _ => at,
    }
}

fn end_of_string(chars: &[char], mut at: usize, quote: char) -> usize {
    while at < chars.len() && chars[at] != quote {
        at += if chars[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(chars.len())
}

fn find(chars: &[char], from: usize, found: impl Fn(usize) -> bool) -> usize {
    (from..chars.len()).find(|&i| found(i)).unwrap_or(chars.len())
}

fn without_unit_tests(code: String) -> String {
    let mut out = code;
    while let Some(start) = out.find("#[cfg(test)]") {
        let rest = &out[start..];
        let open = rest.find('{').unwrap_or(rest.len());
        let end = match rest.find(';') {
            Some(semicolon) if semicolon < open => semicolon + 1,
            _ => end_of_block(rest, open),
        };
        let blank: String = rest[..end].chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect();
        out.replace_range(start..start + end, &blank);
    }
    out
}

/// The end of the braces that open at or after byte `from`.
fn end_of_block(text: &str, from: usize) -> usize {
    let mut depth = 0_i32;
    for (i, c) in text[from..].char_indices() {
        depth += match c {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        if c == '}' && depth == 0 {
            return from + i + 1;
        }
    }
    text.len()
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The lines, from 1, on which `pattern` occurs. An end of the pattern that is a letter must be the end of a word in the
/// text; a `*` there lifts that: `*Mesh*` is found in `PolygonMesh`, `Mesh` is not.
pub(super) fn lines_with(code: &str, pattern: &str) -> Vec<usize> {
    let inner = pattern.trim_matches('*');
    if inner.is_empty() {
        return Vec::new();
    }
    let free_start = pattern.starts_with('*') || !inner.starts_with(is_word);
    let free_end = pattern.ends_with('*') || !inner.ends_with(is_word);
    let hit = |line: &str| {
        line.match_indices(inner).any(|(at, _)| {
            (free_start || !line[..at].ends_with(is_word))
                && (free_end || !line[at + inner.len()..].starts_with(is_word))
        })
    };
    code.lines().enumerate().filter(|(_, line)| hit(line)).map(|(index, _)| index + 1).collect()
}

/// The lines, from 1, of public signatures that name a float, other than those of functions called `approx_*`.
pub(super) fn float_signatures(code: &str) -> Vec<usize> {
    let mut found = Vec::new();
    for (at, _) in code.match_indices("pub ") {
        if code[..at].ends_with(is_word) {
            continue;
        }
        let item = &code[at + 4..];
        let kind = item.split(|c: char| !is_word(c)).next().unwrap_or("");
        match kind {
            "struct" | "mod" | "use" | "extern" => {}
            "enum" => offsets(&item[..end_of_block(item, 0)], &mut found, at + 4),
            "trait" => {
                let body = &item[..end_of_block(item, 0)];
                for (inner, _) in body.match_indices("fn ") {
                    if !body[..inner].ends_with(is_word) {
                        function(&body[inner..], &mut found, at + 4 + inner);
                    }
                }
            }
            _ if signature(item).contains("fn ") => {
                let start = item.find("fn ").unwrap_or(0);
                function(&item[start..], &mut found, at + 4 + start);
            }
            _ => offsets(signature(item), &mut found, at + 4),
        }
    }
    let mut lines: Vec<usize> =
        found.into_iter().map(|offset| code[..offset].matches('\n').count() + 1).collect();
    lines.sort_unstable();
    lines.dedup();
    lines
}

fn function(item: &str, found: &mut Vec<usize>, base: usize) {
    let name = item["fn ".len()..].trim_start();
    if !name.starts_with("approx_") {
        offsets(signature(item), found, base);
    }
}

fn offsets(text: &str, found: &mut Vec<usize>, base: usize) {
    for float in ["f64", "f32"] {
        for (at, _) in text.match_indices(float) {
            if !text[..at].ends_with(is_word) && !text[at + float.len()..].starts_with(is_word) {
                found.push(base + at);
            }
        }
    }
}

/// The text of an item up to its body, value, or the end of the field.
fn signature(item: &str) -> &str {
    let (mut depth, mut before) = (0_i32, ' ');
    for (at, c) in item.char_indices() {
        match c {
            '(' | '[' | '<' => depth += 1,
            ')' | ']' => depth -= 1,
            '>' if before != '-' && before != '=' => depth -= 1,
            '{' => return &item[..at],
            ';' | ',' | '=' | '}' if depth <= 0 => return &item[..at],
            _ => {}
        }
        if depth < 0 {
            return &item[..at];
        }
        before = c;
    }
    item
}

/// How many lines of `code` are not blank.
pub(super) fn code_lines(code: &str) -> usize {
    code.lines().filter(|line| !line.trim().is_empty()).count()
}
