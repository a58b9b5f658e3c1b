//! The XML file of a frequency response measurement of SINUMERIK, element by element as a control writes it, with other numbers;
//! the expected text is in `sinumerik.txt`. The elements and the digits are those of a file that was published with Trace-Tools.

use super::plant::{complex, demonstration, lines, open_plant};
use super::spellings::DEMONSTRATION;
use super::{BANDS, COMMAND, CYCLE_TIME, read_text, said};
use generator::response_file::{From, read};
use stability::Complex64;

const DIGITS: &[u8; 85] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ!#$`()*+-/:;=?@[]^_{|}~";
const WIDTH: usize = 200;

fn base_85(numbers: &[f64]) -> String {
    let words = numbers.iter().flat_map(|number| [number.to_bits() >> 32, number.to_bits() & 0xffff_ffff]);
    let digit = |of: u64| char::from(DIGITS[usize::try_from(of).unwrap()]);
    let digits = |word: u64| match word {
        0 => ".".to_owned(),
        _ => (0..5).rev().map(|place| digit(word / 85_u64.pow(place) % 85)).collect(),
    };
    words.map(digits).collect()
}

fn array(kind: &str, name: &str, numbers: &[f64]) -> String {
    let length = if kind == "double" { numbers.len() } else { numbers.len() / 2 };
    let digits = base_85(numbers);
    let lines = digits.as_bytes().chunks(WIDTH).map(|line| format!("            {}\n", str::from_utf8(line).unwrap()));
    let raw = match numbers {
        [] => "<raw name=\"m_pNumberArray\"/>".to_owned(),
        _ => format!("<raw name=\"m_pNumberArray\"><![CDATA[\n{}            ]]></raw>", lines.collect::<String>()),
    };
    format!(
        "<NumericArray satclassid=\"4\" elementtype=\"{kind}\" format=\"base85\" name=\"{name}\" ver=\"4.7.6.0.3\" env=\"1\">\n\
         <unsigned_int name=\"m_length\">{length}</unsigned_int>\n{raw}\n</NumericArray>\n"
    )
}

/// Averaged spectra, with the id of the second signal.
fn spectrum(name: &str, id: u32, averages: u32, hz: &[f64], values: &[Complex64]) -> String {
    let parts: Vec<f64> = values.iter().flat_map(|value| [value.re, value.im]).collect();
    format!(
        "<SigNodeCrossSpectrumInfo satclassid=\"177\" name=\"{name}\" ver=\"4.7.6.0.3\" env=\"1\">\n\
         <unsigned_int name=\"m_uSignodeId\">{id}</unsigned_int>\n<unsigned_int name=\"m_uSecondId\">0</unsigned_int>\n\
         <unsigned_int name=\"m_uAxisId\">1</unsigned_int>\n\
         <unsigned_int name=\"m_uNumSpectraInAvg\">{averages}</unsigned_int>\n\
         <CrossSpectrum satclassid=\"15\" name=\"m_avgCrossSpec\" ver=\"4.7.6.0.3\" env=\"1\">\n{}{}</CrossSpectrum>\n\
         </SigNodeCrossSpectrumInfo>\n",
        array("ComplexNumber", "m_ValueVector", &parts),
        array("double", "m_FrequencyVector", hz),
    )
}

fn list(name: &str, kind: &str, elements: &str) -> String {
    format!(
        "<LinkedList name=\"{name}\" satclassid=\"3\" elementtype=\"{kind}\" ver=\"0.0.0.0.0\" env=\"1\">\n\
         {elements}</LinkedList>\n"
    )
}

fn node(id: u32, instance: u32, spectra: &str) -> String {
    let series = format!(
        "<TimeSeries satclassid=\"18\" name=\"m_TimeSeriesList_node\" ver=\"4.7.6.0.3\" env=\"1\">\n{}\
         <float name=\"m_TimeVector.start\">0</float>\n<float name=\"m_TimeVector.end\">.255750000000000010658141</float>\n\
         <unsigned_int name=\"m_TimeVector.length\">3</unsigned_int>\n</TimeSeries>\n",
        array("double", "m_ValueVector", &[0.1, 0.2, 0.1])
    );
    format!(
        "<PlatformSignalNode satclassid=\"22\" name=\"m_MeasurementSignalNodeList_node\" ver=\"4.7.6.0.3\" env=\"1\">\n\
         <unsigned_int name=\"m_uNodeId\">{id}</unsigned_int>\n<unsigned_int name=\"m_ePlatformType\">5</unsigned_int>\n\
         <float name=\"m_dIntervalTime\">0</float>\n\
         <TransferFunction satclassid=\"7\" name=\"m_MeasurementLinearDistortion\" ver=\"4.7.6.0.3\" env=\"1\">\n{}{}\
         <float name=\"m_GainValue_real\">1</float>\n<float name=\"m_GainValue_imag\">0</float>\n\
         <float name=\"m_TimeDelay\">0</float>\n</TransferFunction>\n<unsigned_int name=\"m_uAxis\">1</unsigned_int>\n\
         <unsigned_int name=\"m_uArrayIndex\">0</unsigned_int>\n<unsigned_int name=\"m_eSignalUnits\">0</unsigned_int>\n\
         <integer name=\"m_iUniqueInstanceId\">{instance}</integer>\n{}{spectra}</PlatformSignalNode>\n",
        array("ComplexNumber", "m_PolesVector", &[]),
        array("ComplexNumber", "m_ZerosVector", &[]),
        list("m_TimeSeriesList", "TimeSeries", &series),
    )
}

/// What a control measured: a line at 0 Hz, and those of `lines`; a part of the output is noise.
struct Measurement {
    hz: Vec<f64>,
    /// power of the input, different in each line
    uu: Vec<Complex64>,
    yy: Vec<Complex64>,
    /// conj(output) input
    yu: Vec<Complex64>,
    averages: u32,
}

impl Measurement {
    fn of(p: &[Complex64], noise: f64, averages: u32) -> Self {
        let hz: Vec<f64> = [0.0].into_iter().chain(lines().into_iter().take(p.len())).collect();
        let p: Vec<Complex64> = [complex(1.0, 0.0)].into_iter().chain(p.iter().copied()).collect();
        let uu: Vec<Complex64> = hz.iter().map(|hz| complex(8.6e-5 / (1.0 + hz / 300.0), 0.0)).collect();
        let yy = p.iter().zip(&uu).map(|(p, uu)| complex(p.norm_sqr() * uu.re * (1.0 + noise), 0.0)).collect();
        let yu = p.iter().zip(&uu).map(|(p, uu)| p.conj() * uu.re).collect();
        Self { hz, uu, yy, yu, averages }
    }

    /// The output is the first signal, as a control writes it; the last element says which of them is the input.
    fn text(&self) -> String {
        let of = |name, id, values: &[Complex64]| spectrum(name, id, self.averages, &self.hz, values);
        let cross = of("m_crossSpecInfoList_el", 62, &self.yu);
        let of_list = |cross: &str| list("m_crossSpecInfoList", "SigNodeCrossSpectrumInfo", cross);
        let output = node(61, 0, &(of("m_autospectrumInfo", 61, &self.yy) + &of_list(&cross)));
        let input = node(62, 1, &(of("m_autospectrumInfo", 62, &self.uu) + &of_list("")));
        framed(&(output + &input))
    }
}

fn framed(nodes: &str) -> String {
    let pair = "<PrimaryFreqRespSigNodeData satclassid=\"182\" name=\"m_listPrimaryFreqRespSigNodeData_el\" \
        ver=\"4.7.6.0.3\" env=\"1\">\n\
        <unsigned_int name=\"m_uPriority\">0</unsigned_int>\n<integer name=\"m_iInputSigNodeUniqueInstanceID\">1</integer>\n\
        <integer name=\"m_iOutputSigNodeUniqueInstanceID\">0</integer>\n</PrimaryFreqRespSigNodeData>\n";
    format!(
        "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!-- 4.7.6.0.3 -->\n\
         <ResponseTestCustom satclassid=\"174\" ver=\"4.7.6.0.3\" env=\"1\">\n<!-- Members in ResponseTestBase -->\n\
         <float name=\"m_dProcessUpdateTime\">0.000125</float>\n<unsigned_int name=\"m_eControlLoopType\">2</unsigned_int>\n\
         <boolean name=\"m_bValidResult\">false</boolean>\n{}{}\
         <!-- Members in ResponseTestCustom -->\n<unsigned_int name=\"m_eInjectionPoint_rtc\">3</unsigned_int>\n{}\
         <string name=\"Version Info\">\nXML generated by SAT Library Version: 4.7.6.0.3\n</string>\n</ResponseTestCustom>",
        list("m_MeasurementSignalNodeList", "PlatformSignalNode", nodes),
        list("m_DynamicTareSignalNodeList", "PlatformSignalNode", ""),
        list("m_listPrimaryFreqRespSigNodeData", "PrimaryFreqRespSigNodeData", pair),
    )
}

/// Numbers of the published file: 6 rpm and 2 rpm in rad/s, the last frequency and the first two.
#[test]
fn digits_are_those_of_a_control() {
    assert_eq!(base_85(&[0.628316408511465, 0.209441607478678]), "kJA`l149|~kG!pGI$!YV");
    assert_eq!(base_85(&[4000.0, 0.0, 4000.0 / 1022.0]), "k)9AM...kO3U-*9lJ3");
}

#[test]
fn a_measurement_is_the_demonstration_plant() {
    let p = demonstration();
    let text = Measurement::of(&p, 0.0, 2).text();
    let measured = read_text(&text).unwrap_or_else(|report| panic!("{report}"));
    assert_eq!((measured.lines, measured.has_errors), (p.len(), true));
    for (hz, magnitude, phase) in DEMONSTRATION {
        let error = (measured.response.value(hz) / Complex64::from_polar(magnitude, phase.to_radians()) - 1.0).norm();
        assert!(error < 2e-3, "{hz} Hz: {error}");
    }
    // Bytes of ISO 8859-1, ends of lines of Windows.
    let windows = text.replace("4.7.6.0.3 -->", "Gerät -->").replace('\n', "\r\n");
    let bytes: Vec<u8> = windows.chars().map(|letter| u8::try_from(letter).unwrap()).collect();
    let again = read("p.xml", &bytes, COMMAND, CYCLE_TIME, &BANDS).unwrap_or_else(|report| panic!("{report}"));
    assert!(lines().into_iter().all(|hz| again.response.value(hz) == measured.response.value(hz)));
}

/// The list of the input may have the cross spectrum too: with its factors the other way round.
#[test]
fn the_cross_spectrum_of_the_input_is_the_conjugate_one() {
    let of = Measurement::of(&demonstration(), 0.0, 2);
    let expected = read_text(&of.text()).unwrap();
    let uy: Vec<Complex64> = of.yu.iter().map(Complex64::conj).collect();
    let spectrum = |name, id, values: &[Complex64]| spectrum(name, id, 2, &of.hz, values);
    let cross = spectrum("m_crossSpecInfoList_el", 61, &uy);
    let cross = list("m_crossSpecInfoList", "SigNodeCrossSpectrumInfo", &cross);
    let input = node(62, 1, &(spectrum("m_autospectrumInfo", 62, &of.uu) + &cross));
    let without = list("m_crossSpecInfoList", "SigNodeCrossSpectrumInfo", "");
    let output = node(61, 0, &(spectrum("m_autospectrumInfo", 61, &of.yy) + &without));
    let found = read_text(&framed(&(input + &output))).unwrap_or_else(|report| panic!("{report}"));
    assert!(lines().into_iter().all(|hz| found.response.value(hz) == expected.response.value(hz)));
}

/// Noise of a tenth of the power: k = 1/1.1, and sqrt((1 - k)/(2 n k)) with n spectra.
#[test]
fn spectra_give_the_standard_error() {
    let text = Measurement::of(&demonstration(), 0.1, 2).text();
    let measured = read_text(&text).unwrap_or_else(|report| panic!("{report}"));
    for hz in [5.0, 20.0, 100.0] {
        let relative = measured.response.relative_error(hz);
        assert!((relative / (0.1_f64 / 4.0).sqrt() - 1.0).abs() < 1e-6, "{hz} Hz: {relative}");
    }
    assert!(!read_text(&Measurement::of(&demonstration(), 0.0, 1).text()).unwrap().has_errors);
}

/// From the current setpoint: the same file, of the open speed plant.
#[test]
fn an_open_plant_is_closed() {
    let p: Vec<Complex64> = lines().into_iter().map(open_plant).collect();
    let from = From::Current { kp: 2.0, tn: 0.02, delay: 2e-3 };
    let names = "f [Hz];re;im";
    let table = super::table(names, &lines(), |hz| format!("{};{}", open_plant(hz).re, open_plant(hz).im));
    let expected = read("p.csv", table.as_bytes(), from, CYCLE_TIME, &BANDS).unwrap();
    let found = read("p.xml", Measurement::of(&p, 0.0, 2).text().as_bytes(), from, CYCLE_TIME, &BANDS).unwrap();
    assert!(lines().into_iter().all(|hz| (found.response.value(hz) - expected.response.value(hz)).norm() < 1e-9));
}

#[test]
fn each_defect_gets_its_verdict() {
    let whole = Measurement::of(&demonstration(), 0.01, 2).text();
    let with = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        whole.replacen(from, to, 1)
    };
    let cross = whole.find("m_crossSpecInfoList_el").unwrap();
    let in_cross = |from: &str, to: &str| whole[..cross].to_owned() + &whole[cross..].replacen(from, to, 1);
    let of = |change: &dyn Fn(&mut Measurement)| {
        let mut of = Measurement::of(&demonstration(), 0.01, 2);
        change(&mut of);
        of.text()
    };
    let pair = whole.split("<PrimaryFreqRespSigNodeData").nth(1).unwrap().split("</PrimaryFreqRespSigNodeData>").next();
    let pair = format!("<PrimaryFreqRespSigNodeData{}</PrimaryFreqRespSigNodeData>", pair.unwrap());
    let files = [
        ("broken", whole[..whole.len() / 2].to_owned()),
        ("a document type", with("<!-- 4.7.6.0.3 -->", "<!DOCTYPE x [<!ENTITY a \"b\">]>")),
        ("a trace", "<traceCaptureFile>\n<traceData><dataFrame/></traceData>\n</traceCaptureFile>".to_owned()),
        ("a tuning", "<Tuning><DynamicModelPositionController840DSL/></Tuning>".to_owned()),
        ("another XML", "<?xml version=\"1.0\"?>\n<Project/>".to_owned()),
        ("no spectra", framed(&(node(61, 0, "") + &node(62, 1, "")))),
        ("two responses", with(&pair, &format!("{pair}\n{pair}"))),
        ("no such input", with("InputSigNodeUniqueInstanceID\">1", "InputSigNodeUniqueInstanceID\">7")),
        ("two signals alike", with("m_uNodeId\">62", "m_uNodeId\">61")),
        ("a gain", with("m_GainValue_real\">1", "m_GainValue_real\">9.55")),
        ("poles", with("m_length\">0", "m_length\">2")),
        ("another format", in_cross("base85", "base64")),
        ("another digit", in_cross("kO", "k&amp;")),
        ("a digit that base 85 has not", in_cross("..k", ".,k")),
        ("cut digits", in_cross("            ]]>", "            k]]>")),
        ("more than 32 bits", in_cross("            k", "            ~~~~~k")),
        ("a number missing", in_cross("m_length\">1001", "m_length\">1002")),
        ("not a number", of(&|of| of.yu[7].im = f64::NAN)),
        ("no power", of(&|of| of.uu[9].re = 0.0)),
        ("more than is there", of(&|of| of.yu[9] *= 1.2)),
        ("other frequencies", in_cross(&base_85(&[0.0, 0.25]), &base_85(&[0.0, 0.2501]))),
        ("input and output exchanged", {
            with("InputSigNodeUniqueInstanceID\">1", "InputSigNodeUniqueInstanceID\">2")
                .replacen("OutputSigNodeUniqueInstanceID\">0", "OutputSigNodeUniqueInstanceID\">1", 1)
                .replacen("InputSigNodeUniqueInstanceID\">2", "InputSigNodeUniqueInstanceID\">0", 1)
        }),
        ("rpm over rad/s", {
            let scaled = |values: &mut Vec<Complex64>, by: f64| values.iter_mut().for_each(|value| *value *= by);
            of(&|of| [(&mut of.yu, 9.549), (&mut of.yy, 9.549 * 9.549)].into_iter().for_each(|(v, by)| scaled(v, by)))
        }),
    ];
    let all: Vec<(&str, String)> = files.into_iter().map(|(name, text)| (name, said(&text, COMMAND))).collect();
    let found: String = all.iter().map(|(name, said)| format!("> {name}\n{said}\n")).collect();
    assert!(all.iter().all(|(_, said)| said.contains("error[")), "{found}");
    transcript::equals(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/response_file/sinumerik.txt"), &found);
}

/// A file that is damaged in some byte is read or refused.
#[test]
fn damaged_files_do_not_panic() {
    let whole = Measurement::of(&demonstration()[..60], 0.01, 2).text();
    let (mut noise, mut refused) = (1_u32, 0);
    for _ in 0..400 {
        let mut bytes = whole.clone().into_bytes();
        noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let at = usize::try_from(noise >> 8).unwrap() % bytes.len();
        bytes[at] = b"0<>/.=\"~"[usize::try_from(noise % 8).unwrap()];
        let read = read("p.xml", &bytes, COMMAND, CYCLE_TIME, &[]);
        refused += usize::from(read.is_err_and(|report| report.has_errors()));
    }
    assert!((100..400).contains(&refused), "{refused}");
}
