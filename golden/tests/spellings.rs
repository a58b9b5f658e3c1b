//! One recording in every form that TwinCAT Scope gives it: separator, decimal mark, columns of times, order of the channels,
//! end, encoding, line ends. All of them are read as the same samples.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use compiler::program::Type;
use golden::measure;
use golden::mistake::Mistake;
use golden::recording::{self, Recording};
use golden::samples::{Shape, Signal};
use golden::table::Table;
use portable::{Literal, RealKind};
use std::ops::Range;

/// How a column of times belongs to channels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Times {
    PerChannel,
    PerRate,
    One,
    None,
}

/// The form of a file.
#[derive(Clone, Copy, Debug)]
struct Form {
    separator: char,
    mark: char,
    times: Times,
    /// the fast channel stands first, so that rows end early; otherwise it stands in the middle, and blanks fill the rows
    is_sorted: bool,
    /// times as 100 ns since 1601
    is_full: bool,
    has_end: bool,
    line_end: &'static str,
}

/// A channel: its name, its symbol, its type, its sampling time [us], when its first sample was taken [us].
type Channel = (&'static str, &'static str, &'static str, u32, i32);

/// Several channels show one symbol; names have blanks, brackets and umlauts.
const CHANNELS: [Channel; 6] = [
    ("Motor speed", "MAIN.fbX.fVelo", "REAL64", 1000, 0),
    ("Motor speed (1)", "MAIN.fbX.fVelo", "REAL64", 1000, 0),
    ("Dr\u{fc}cke[{\u{e4}\u{f6}\u{df}}]", "MAIN.fbX.fCorr", "REAL64", 1000, 0),
    ("ready", "MAIN.fbX.bReady", "BIT", 1000, 0),
    ("fast", "MAIN.fbX.fFast", "REAL32", 200, 0),
    ("slow", "MAIN.fbX.fVelo", "REAL32", 5000, -3000),
];
const UNITS: [(&str, &str); 2] =
    [("Motor speed (1)", "mm/s (Velocity)"), ("Dr\u{fc}cke[{\u{e4}\u{f6}\u{df}}]", "dV (Voltage)")];
const SAMPLES: u32 = 40;
const SEPARATORS: [char; 5] = ['\t', ';', ' ', ':', ','];

/// The value of a channel in its sample.
fn value(channel: usize, sample: u32) -> String {
    let sample = f64::from(sample);
    match channel {
        0 => format!("{:.3}", 12.5 * sample - 7.125),
        1 => format!("{:.3}", 0.25 * sample),
        2 => format!("{:.4}", -1.5 * sample),
        3 => "1".to_owned(),
        _ => format!("{sample}"),
    }
}

/// The file.
fn written(form: Form) -> String {
    let has_rates = matches!(form.times, Times::PerChannel | Times::PerRate);
    let order: &[usize] = match (has_rates, form.is_sorted) {
        (true, true) => &[4, 0, 1, 2, 3, 5],
        (true, false) => &[0, 1, 4, 2, 5, 3],
        (false, _) => &[0, 1, 2, 3],
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for channel in order {
        let is_same = |group: &Vec<usize>| CHANNELS[group[0]].3 == CHANNELS[*channel].3;
        match groups.last_mut() {
            Some(group) if form.times != Times::PerChannel && is_same(group) => group.push(*channel),
            _ => groups.push(vec![*channel]),
        }
    }
    let separator = form.separator.to_string();
    let quoted = |text: &str| if form.separator == ' ' { format!("\"{text}\"") } else { text.to_owned() };
    let mut lines = vec![
        ["Name", &quoted("A project")].join(&separator),
        ["File", &quoted("C:\\data\\x.csv")].join(&separator),
        [&quoted("Starttime of export"), "133000000000000000", &quoted("Montag, 2. M\u{e4}rz"), "15:56:24.376"]
            .join(&separator),
        String::new(),
        String::new(),
    ];
    let row = |key: &str, of: &dyn Fn(&Channel) -> String| {
        let group = |group: &Vec<usize>| {
            let values = group.iter().map(|channel| of(&CHANNELS[*channel]));
            [key.to_owned()].into_iter().chain(values).collect::<Vec<_>>().join(&separator)
        };
        groups.iter().map(group).collect::<Vec<_>>().join(&separator)
    };
    let milliseconds = |micros: i64, mark: char| (micros as f64 / 1000.0).to_string().replace('.', &mark.to_string());
    lines.push(row("Name", &|channel| channel.0.to_owned()));
    lines.push(row("SymbolComment", &|_| String::new()));
    lines.push(row("Data-Type", &|channel| channel.2.to_owned()));
    // In the language of the PC, whatever the decimal mark of the samples is.
    lines.push(row("SampleTime[ms]", &|channel| milliseconds(i64::from(channel.3), ',')));
    lines.push(row("SymbolName", &|channel| channel.1.to_owned()));
    let unit = |channel: &Channel| UNITS.iter().find(|of| of.0 == channel.0).map_or("(None)", |of| of.1);
    lines.push(row("Unit", &|channel| unit(channel).to_owned()));
    lines.push(row("Unit Offset", &|_| "0".to_owned()));
    lines.push(String::new());
    let count = |channel: usize| SAMPLES * 1000 / CHANNELS[channel].3;
    for sample in 0..order.iter().map(|channel| count(*channel)).max().unwrap() {
        let mut cells = Vec::new();
        for group in &groups {
            let is_there = sample < count(group[0]);
            let blank = || " ".to_owned();
            let time = i64::from(CHANNELS[group[0]].4) + i64::from(sample) * i64::from(CHANNELS[group[0]].3);
            let time = match form.is_full {
                true => (133_000_000_000_000_000 + 10 * time).to_string(),
                false => milliseconds(time, form.mark),
            };
            cells.extend((form.times != Times::None).then(|| if is_there { time } else { blank() }));
            let of = |channel: &usize| value(*channel, sample).replace('.', &form.mark.to_string());
            cells.extend(group.iter().map(|channel| if is_there { of(channel) } else { blank() }));
        }
        while cells.last().is_some_and(|cell| cell == " ") {
            cells.pop();
        }
        lines.push(cells.join(&separator));
    }
    lines.extend(form.has_end.then(|| "EOF".to_owned()));
    lines.join(form.line_end) + form.line_end
}

/// The file with one cell of each sample changed.
fn changed(form: Form, at: usize, change: impl Fn(usize, &str) -> String) -> String {
    let (text, separator) = (written(form), form.separator.to_string());
    let head = text.lines().position(|line| line.starts_with("Unit Offset")).unwrap() + 2;
    let of = |(line, text): (usize, &str)| {
        let mut cells: Vec<String> = text.split(form.separator).map(str::to_owned).collect();
        if let Some(cell) = cells.get_mut(at).filter(|_| line >= head) {
            *cell = change(line - head, cell);
        }
        cells.join(&separator) + "\n"
    };
    text.lines().enumerate().map(of).collect()
}

/// The bytes of a text, and what is written before them.
const ENCODINGS: [fn(&str) -> Vec<u8>; 4] = [
    |text| text.as_bytes().to_vec(),
    |text| ["\u{feff}", text].concat().into_bytes(),
    |text| text.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect(),
    |text| [0xFEFF].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect(),
];

fn shapes() -> [Shape; 2] {
    let real = |name: &str| Signal { name: name.to_owned(), ty: Type::Real, start: Literal::F64(0.0) };
    let is_ready = Signal { name: "is_ready".to_owned(), ty: Type::Bool, start: Literal::Bool(false) };
    let of = |signals: &[Signal]| Shape { real: RealKind::F64, signals: signals.to_vec() };
    [of(&[real("v_motor"), real("v_command"), is_ready]), of(&[real("v_add")])]
}

fn read(text: &str, map: &[(&str, &str)]) -> Result<Recording, Vec<Mistake>> {
    let map: Vec<(String, String)> = map.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
    let wanted: Vec<&str> = map.iter().map(|(name, _)| name.as_str()).collect();
    let [inputs, outputs] = shapes();
    recording::read(&Table::read(text, &wanted), [&inputs, &outputs], true, &map, 1_000_000)
}

/// Three of the channels, to be measured.
fn measured(text: &str) -> Result<Vec<measure::Channel>, Vec<Mistake>> {
    let map = [("Motor speed", "v_motor"), ("Motor speed (1)", "v_command"), (CHANNELS[2].0, "a_load")];
    let wanted = map.map(|(name, _)| name);
    measure::read(&Table::read(text, &wanted), &map.map(|(name, signal)| (name.to_owned(), signal.to_owned())))
}

const MAP: [(&str, &str); 4] = [
    ("Motor speed", "v_motor"),
    ("Motor speed (1)", "v_command"),
    ("Dr\u{fc}cke[{\u{e4}\u{f6}\u{df}}]", "v_add"),
    ("MAIN.fbX.bReady", "is_ready"),
];

fn forms() -> impl Iterator<Item = Form> {
    let times = [Times::PerChannel, Times::PerRate, Times::One, Times::None];
    (0..5 * 128).map(move |form: usize| {
        let [has_comma, is_sorted, is_full, has_end, is_long] = [64, 1, 2, 4, 8].map(|bit| form & bit > 0);
        let (mark, line_end) = (if has_comma { ',' } else { '.' }, if is_long { "\r\n" } else { "\n" });
        let (separator, times) = (SEPARATORS[form / 128], times[form / 16 % 4]);
        Form { separator, mark, times, is_sorted, is_full, has_end, line_end }
    })
}

#[test]
fn every_form_is_read_as_the_same_samples() {
    let mut count = 0;
    for form in forms().filter(|form| (form.separator, form.mark) != (',', ',')) {
        let text = written(form);
        for encode in ENCODINGS {
            let text = generator::config::characters(encode(&text));
            let read = read(&text, &MAP).unwrap_or_else(|mistakes| panic!("{form:?}\n{mistakes:?}\n{text}"));
            assert_eq!(read.inputs.len(), usize::try_from(SAMPLES).unwrap(), "{form:?}");
            let mut values = Vec::new();
            for sample in 0..SAMPLES {
                let at = usize::try_from(sample).unwrap();
                let number = |channel: usize| Literal::F64(value(channel, sample).parse().unwrap());
                read.inputs.read(at, &mut values);
                assert_eq!(values, [number(0), number(1), Literal::Bool(true)], "{form:?} {sample}");
                read.outputs.read(at, &mut values);
                assert_eq!(values, [number(2)], "{form:?} {sample}");
            }
            let [command, motor, load] = &measured(&text).unwrap()[..] else { panic!("{form:?}") };
            let units = [command, motor, load].map(|channel| channel.unit.map(|unit| unit.name));
            let units = (units, load.other_unit.as_deref());
            assert_eq!(units, ([Some("mm/s"), None, None], Some("dV")), "{form:?}");
            let line = text.lines().nth(read.lines[7] - 1).unwrap();
            assert!(line.contains(&value(0, 7).replace('.', &form.mark.to_string())), "{form:?}: {line}");
            count += 1;
        }
    }
    assert_eq!(count, 9 * 4 * 2 * 2 * 2 * 2 * 4);
}

/// Between commas a decimal comma cannot be distinguished from a separator: one message says what to do.
#[test]
fn decimal_commas_between_commas_are_refused() {
    for form in forms().filter(|form| (form.separator, form.mark) == (',', ',')) {
        let mistakes = read(&written(form), &MAP).unwrap_err();
        let [mistake] = &mistakes[..] else { panic!("{form:?}: {mistakes:?}") };
        assert!(mistake.found.contains(" cells, and ") && mistake.found.ends_with(" more rows"), "{mistake:?}");
        assert_eq!(mistake.instead, "export with a decimal point, or with semicolons or tabs between the cells");
    }
}

const FORM: Form = Form {
    separator: '\t',
    mark: '.',
    times: Times::PerRate,
    is_sorted: true,
    is_full: false,
    has_end: false,
    line_end: "\n",
};

/// All channels of other sampling times are named at once.
#[test]
fn channels_of_other_sampling_times_are_named_at_once() {
    let map = [("fast", "v_motor"), ("slow", "v_command"), MAP[2]];
    for separator in SEPARATORS {
        let mistakes = read(&written(Form { separator, ..FORM }), &map).unwrap_err();
        let [mistake] = &mistakes[..] else { panic!("{mistakes:?}") };
        assert_eq!(mistake.code, "AX480");
        assert_eq!(mistake.found, "samples every 0.2 ms of fast, every 5 ms of slow; the block runs every 1 ms");
        assert_eq!(mistake.instead, "record these columns every 1 ms, or leave them out: --map fast=- --map slow=-");
    }
}

/// A symbol that several channels show does not name one of them.
#[test]
fn a_symbol_of_several_channels_is_refused() {
    let mistakes = read(&written(FORM), &[("MAIN.fbX.fVelo", "v_motor"), MAP[2]]).unwrap_err();
    let [mistake] = &mistakes[..] else { panic!("{mistakes:?}") };
    assert_eq!(mistake.found, "3 channels show `MAIN.fbX.fVelo`, which --map names");
    assert_eq!(mistake.allowed, "Motor speed, Motor speed (1), slow");
}

/// A channel that begins later decides where all begin; one that lies between the cycles of the others is refused.
#[test]
fn channels_begin_together() {
    let form = Form { times: Times::PerChannel, ..FORM };
    let first_at = 2 + 2 * 2; // after those of `fast` and of both speeds
    let later = |by: f64| {
        changed(form, first_at, |_, cell| cell.parse().map_or(String::new(), |time: f64| (time + by).to_string()))
    };
    let recording = read(&later(2.0), &MAP).unwrap();
    assert_eq!(recording.skipped, ["v_motor", "v_command", "is_ready"].map(|name| (name.to_owned(), 2)));
    assert_eq!(recording.outputs.len(), 38);
    let mut values = Vec::new();
    recording.inputs.read(0, &mut values);
    assert_eq!(values[0], Literal::F64(value(0, 2).parse().unwrap()));
    recording.outputs.read(0, &mut values);
    assert_eq!(values[0], Literal::F64(value(2, 0).parse().unwrap()));
    let mistakes = read(&later(0.4), &MAP).unwrap_err();
    assert_eq!(mistakes.len(), 1);
    assert!(mistakes[0].found.contains(" was sampled 0.4 ms apart from the others"), "{mistakes:?}");
}

/// Values that are missing between others are a mistake, for measurements too; one message says how many are. Before the
/// first value they are not: the channel begins later, if it has times.
#[test]
fn values_that_are_missing() {
    let without = |samples: Range<usize>, form: Form, cell| {
        changed(form, cell, |sample, cell| if samples.contains(&sample) { String::new() } else { cell.to_owned() })
    };
    let text = without(18..21, FORM, 3);
    for mistakes in [read(&text, &MAP).unwrap_err(), measured(&text).unwrap_err()] {
        let [Mistake { line, column, found, .. }] = &mistakes[..] else { panic!("{mistakes:?}") };
        assert_eq!((*line, *column), (32, text.lines().nth(31).unwrap().find("\t\t").unwrap() + 2));
        assert_eq!(found, "3 values are missing in the middle of the column `Motor speed`");
    }
    let text = without(0..3, FORM, 3);
    assert_eq!(read(&text, &MAP).unwrap().skipped, ["v_command", "v_add", "is_ready"].map(|name| (name.to_owned(), 3)));
    let channels = measured(&text).unwrap();
    assert_eq!([0, 1].map(|at| channels[at].timing.begins), [Some(0), Some(3_000_000)]);
    let mistakes = read(&without(0..3, Form { times: Times::None, ..FORM }, 0), &MAP).unwrap_err();
    assert_eq!(mistakes[0].found, "3 values are missing at the start of the column `Motor speed`");
}

/// The last channel has no sample at first, or none at all: the cells before it are read as before.
#[test]
fn a_last_channel_without_samples() {
    for (times, last, is_full) in [(Times::One, 4, false), (Times::One, 4, true), (Times::None, 3, false)] {
        for (separator, count) in [('\t', 3), (' ', 3), ('\t', SAMPLES), (' ', SAMPLES), (',', SAMPLES)] {
            let form = Form { separator, times, is_full, ..FORM };
            let map = [MAP[0], MAP[1], MAP[2], ("ready", "-")];
            let text =
                changed(form, last, |at, cell| if at < count as usize { String::new() } else { cell.to_owned() });
            for text in [text.replace(&format!("{separator}\n"), "\n"), text] {
                let (read, whole) = (read(&text, &map).unwrap(), read(&written(form), &map).unwrap());
                assert_eq!((read.inputs, read.outputs), (whole.inputs, whole.outputs), "{form:?} {count}\n{text}");
            }
        }
    }
}

/// A scope fills the rows of slower channels with their last samples. With their times they are read once; without, a row does
/// not show when it was sampled.
#[test]
fn samples_that_a_scope_repeats() {
    let text = written(FORM);
    let (head, rows) = text.split_at(text.find("\n\n0\t").unwrap() + 2);
    let rows: Vec<Vec<&str>> = rows.lines().map(|row| row.split('\t').collect()).collect();
    let row = |n: usize| [&rows[n][..2], &rows[n / 5][2..7]].concat().join("\t") + "\n";
    let repeated = head.to_owned() + &(0..rows.len()).map(row).collect::<String>();
    assert_eq!(read(&repeated, &MAP).unwrap().outputs, read(&text, &MAP).unwrap().outputs);
    assert_eq!(measured(&repeated).unwrap()[1].timing.interval, Some(1e-3));
    let form = Form { times: Times::None, ..FORM };
    let ends = written(form).replace("\n\n\n", "\nEndtime of export\t133000000000400000\n\n\n");
    assert_eq!(read(&ends, &MAP).unwrap().outputs.len(), 40);
    let twice: String =
        ends.lines().map(|line| [line, "\n"].concat().repeat(if line.ends_with("\t1") { 2 } else { 1 })).collect();
    let faster = written(form).replace("SampleTime[ms]\t1\t", "SampleTime[ms]\t0,5\t");
    for (text, names) in [(twice, "Motor speed, Motor speed (1), "), (faster, "Motor speed (1), ")] {
        for mistakes in [read(&text, &MAP).unwrap_err(), measured(&text).unwrap_err()] {
            let said = format!("more rows than samples, one every 1 ms, of {names}");
            assert!(mistakes[0].code == "AX530" && mistakes[0].found.starts_with(&said), "{mistakes:?}");
        }
    }
}

/// Separators at the end of the row of units, and a row that does not fit.
#[test]
fn units_of_a_row_that_is_longer() {
    let unit = |more: &str| {
        let text = written(FORM).replace("\nUnit Offset", &format!("{more}\nUnit Offset"));
        let command = measured(&text).unwrap().remove(0);
        (command.unit.map(|unit| unit.name), command.other_unit)
    };
    assert_eq!([unit(""), unit("\t"), unit("\t\t\t")], [const { (Some("mm/s"), None) }; 3]);
    assert_eq!(unit("\tmm"), (None, Some("row Unit does not fit the channels".to_owned())));
}

/// Names with blanks between blanks, which neither the user nor a second channel of the name reports apart.
#[test]
fn names_that_are_not_told_apart_are_replaced_by_symbols() {
    let text = written(Form { separator: ' ', ..FORM }).replace("Motor speed (1)", "Command speed");
    let by_symbol = [("MAIN.fbX.fCorr", "v_add"), ("MAIN.fbX.bReady", "is_ready")];
    assert_eq!(read(&text, &by_symbol).unwrap().outputs.len(), 40);
    // The user names them: that is enough.
    let by_name = [("Motor speed", "v_motor"), ("Command speed", "v_command"), MAP[2]];
    assert_eq!(read(&text, &by_name).unwrap().given, [0, 1]);
}

/// Two channels of a symbol that is a signal: one of them is chosen, by its name or by the map.
#[test]
fn two_channels_of_a_signal() {
    let both = written(FORM).replace("MAIN.fbX.fVelo", "MAIN.fbX.v_motor");
    let slow = [("slow", "-"), MAP[2]];
    let mistakes = read(&both, &slow).unwrap_err();
    let [mistake] = &mistakes[..] else { panic!("{mistakes:?}") };
    assert_eq!(mistake.found, "the column `Motor speed (1)` a second time");
    assert_eq!(mistake.instead, "--map \"Motor speed (1)=-\", or another channel of this symbol");
    assert_eq!(read(&both, &[("Motor speed (1)", "-"), slow[0], slow[1]]).unwrap().given, [0]);
    let named = both.replace("\tMotor speed\t", "\tv_motor\t");
    assert_eq!(read(&named, &slow).unwrap().given, [0]);
}
