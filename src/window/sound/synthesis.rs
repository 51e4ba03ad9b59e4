//! The sounds: a short push, as long as the bodies touch, that rings a few modes.

use std::io::Cursor;
use std::time::Duration;

use fundsp::prelude64::{
    An, AudioNode, AudioUnit, U0, U1, Wave, brown, delay, impulse, lowpass_hz, pass, resonator_hz,
};
use hound::{SampleFormat, WavSpec, WavWriter};

/// Samples per second.
const RATE: u32 = 44_100;
/// Length of every sound.
pub(super) const LENGTH: Duration = Duration::from_millis(400);
/// How many hardnesses of a hit there are: soft, medium, hard.
pub(super) const HARDNESSES: usize = 3;
/// Length of the sound of rolling, which goes on and on.
pub(super) const ROLLING: Duration = Duration::from_secs(3);
/// Seconds in which its end passes into its beginning.
const FADE: f64 = 0.3;
/// Loudest sample, of 1.
const PEAK: f32 = 0.9;

/// What hits what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sound {
    /// Leather tip on ball.
    Tip,
    /// Ball on ball.
    Balls,
    /// Ball on rubber.
    Cushion,
    /// Ball into pocket.
    Pocket,
    /// A button of a panel.
    Click,
}

impl Sound {
    pub(super) const ALL: [Self; 5] = [
        Self::Tip,
        Self::Balls,
        Self::Cushion,
        Self::Pocket,
        Self::Click,
    ];

    /// The sound as a source without inputs. A harder hit is shorter, so it rings higher modes: `edge` in Hz is where the
    /// push runs out of force.
    fn source(self, hardness: usize) -> Box<dyn AudioUnit> {
        let harder = [0.5, 1.0, 1.8][hardness.min(HARDNESSES - 1)];
        let push = |edge: f32| push(harder * edge);
        match self {
            Self::Tip => Box::new(
                push(1200.0)
                    >> (mode(1.0, 620.0, 90.0)
                        & mode(0.7, 1340.0, 140.0)
                        & mode(0.3, 2900.0, 260.0)),
            ),
            Self::Balls => Box::new(
                push(4500.0)
                    >> (mode(0.6, 2350.0, 130.0)
                        & mode(1.0, 4650.0, 180.0)
                        & mode(0.6, 7300.0, 260.0)),
            ),
            Self::Cushion => Box::new(
                push(300.0)
                    >> (mode(1.0, 96.0, 16.0) & mode(0.8, 187.0, 24.0) & mode(0.4, 415.0, 60.0)),
            ),
            Self::Click => {
                Box::new(push(2000.0) >> (mode(1.0, 1750.0, 300.0) & mode(0.5, 3100.0, 500.0)))
            }
            // The ball knocks twice: at the back of the pocket, then at the bottom.
            Self::Pocket => {
                let second_knock = 0.6 * delay(0.085);
                Box::new(
                    push(700.0)
                        >> (pass() & second_knock)
                        >> (mode(1.0, 140.0, 16.0)
                            & mode(0.8, 330.0, 34.0)
                            & mode(0.4, 790.0, 80.0)),
                )
            }
        }
    }
}

/// The force of a hit: one pulse without anything above `edge` in Hz.
fn push(edge: f32) -> An<impl AudioNode<Inputs = U0, Outputs = U1>> {
    impulse::<U1>() >> lowpass_hz(edge, 0.7)
}

/// A mode that rings at this frequency in Hz and dies away the faster the wider its band in Hz is.
fn mode(loudness: f32, frequency: f32, band: f32) -> An<impl AudioNode<Inputs = U1, Outputs = U1>> {
    loudness * resonator_hz(frequency, band)
}

/// The sound at one of [`HARDNESSES`] as a WAV file in memory.
///
/// # Errors
/// [`hound::Error`] if the samples cannot be written.
pub(super) fn wav(sound: Sound, hardness: usize) -> Result<Vec<u8>, hound::Error> {
    file(&rendered(&mut *sound.source(hardness), LENGTH))
}

fn rendered(source: &mut dyn AudioUnit, length: Duration) -> Vec<f32> {
    let wave = Wave::render(f64::from(RATE), length.as_secs_f64(), source);
    (0..wave.length()).map(|i| wave.at(0, i)).collect()
}

/// Length of the sound of a ball that comes back below the table.
pub(super) const RETURN: Duration = Duration::from_millis(2200);

/// A ball that runs down the wooden gully below the table, over its joints, and knocks against those that are there, as a
/// WAV file in memory.
///
/// # Errors
/// [`hound::Error`] if the samples cannot be written.
pub(super) fn ball_return() -> Result<Vec<u8>, hound::Error> {
    // Seconds after the drop: when the run begins and when it ends in a knock.
    const BEGINS: f32 = 0.15;
    const KNOCKS: f32 = 1.75;
    let mut wood = brown()
        >> lowpass_hz(900.0, 0.6)
        >> (mode(1.0, 165.0, 60.0) & mode(0.8, 310.0, 90.0) & mode(0.35, 720.0, 200.0));
    let mut samples = rendered(&mut wood, RETURN);
    let loudest = samples
        .iter()
        .fold(f32::MIN_POSITIVE, |m, s| m.max(s.abs()));
    for (i, sample) in samples.iter_mut().enumerate() {
        let time = i as f32 / RATE as f32;
        let run = ((time - BEGINS) / (KNOCKS - BEGINS)).clamp(0.0, 1.0);
        // It gathers speed, and beats on the joints of the gully faster and faster.
        let joint = (9.0 * run * run).fract();
        let beat = 0.55 + 0.45 * libm::expf(-9.0 * joint);
        let on = if (BEGINS..KNOCKS).contains(&time) {
            1.0
        } else {
            0.0
        };
        let fade = (12.0 * run).min(1.0) * (25.0 * (1.0 - run)).min(1.0);
        *sample *= 0.42 * on * fade * beat * (0.35 + 0.65 * run) / loudest;
    }
    let knock = rendered(&mut *Sound::Balls.source(0), LENGTH);
    let box_of_wood = rendered(&mut *Sound::Pocket.source(0), LENGTH);
    let peak = |samples: &[f32]| {
        samples
            .iter()
            .fold(f32::MIN_POSITIVE, |m, s| m.max(s.abs()))
    };
    let (hard, dull) = (0.8 / peak(&knock), 0.6 / peak(&box_of_wood));
    let at = (KNOCKS * RATE as f32) as usize;
    for (sample, (a, b)) in samples[at..].iter_mut().zip(knock.iter().zip(&box_of_wood)) {
        *sample += hard * a + dull * b;
    }
    file(&samples)
}

/// Balls that roll over cloth, as a WAV file in memory whose end leads to its beginning.
///
/// # Errors
/// [`hound::Error`] if the samples cannot be written.
pub(super) fn rolling() -> Result<Vec<u8>, hound::Error> {
    let mut source = brown() >> lowpass_hz(420.0, 0.6);
    let seconds = ROLLING.as_secs_f64();
    let wave = Wave::render(f64::from(RATE), seconds + FADE, &mut source);
    let length = (seconds * f64::from(RATE)) as usize;
    let fade = wave.length() - length;
    let samples: Vec<f32> = (0..length)
        .map(|i| {
            // The beginning grows out of what would come after the end.
            let share = (i as f32 / fade as f32).min(1.0);
            let after = if i < fade {
                wave.at(0, length + i)
            } else {
                0.0
            };
            share * wave.at(0, i) + (1.0 - share) * after
        })
        .collect();
    file(&samples)
}

fn file(samples: &[f32]) -> Result<Vec<u8>, hound::Error> {
    let loudest = samples
        .iter()
        .fold(f32::MIN_POSITIVE, |most, value| most.max(value.abs()));
    let mut bytes = Cursor::new(Vec::new());
    let mut writer = WavWriter::new(
        &mut bytes,
        WavSpec {
            channels: 1,
            sample_rate: RATE,
            bits_per_sample: 16,
            sample_format: SampleFormat::Int,
        },
    )?;
    for value in samples {
        writer.write_sample(sample(value / loudest))?;
    }
    writer.finalize()?;
    Ok(bytes.into_inner())
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounded to the 16 bits of the file"
)]
fn sample(value: f32) -> i16 {
    (value * PEAK * f32::from(i16::MAX)).round() as i16
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(sound: Sound, hardness: usize) -> Vec<f32> {
        let bytes = wav(sound, hardness).expect("memory can be written");
        let reader = hound::WavReader::new(Cursor::new(bytes)).expect("a WAV file");
        let read = reader.into_samples::<i16>();
        read.map(|sample| f32::from(sample.expect("16 bits")) / f32::from(i16::MAX))
            .collect()
    }

    #[test]
    fn every_sound_begins_loud_and_dies_away() {
        for sound in Sound::ALL {
            for hardness in 0..HARDNESSES {
                let samples = samples(sound, hardness);
                let loudest = |part: &[f32]| part.iter().fold(0.0_f32, |most, s| most.max(s.abs()));
                assert_eq!(samples.len(), 17_640);
                assert!((loudest(&samples) - PEAK).abs() < 1e-3, "{sound:?}");
                assert!(loudest(&samples[..4410]) > 0.85, "{sound:?} begins late");
                assert!(loudest(&samples[15_000..]) < 0.05, "{sound:?} is cut off");
            }
        }
    }

    #[test]
    fn rolling_goes_on_without_a_knock() {
        let bytes = rolling().expect("memory can be written");
        let reader = hound::WavReader::new(Cursor::new(bytes)).expect("a WAV file");
        let samples: Vec<i16> = reader.into_samples().map(|s| s.expect("16 bits")).collect();
        assert_eq!(samples.len(), 3 * 44_100);
        let step = |a: i16, b: i16| i32::from(a).abs_diff(i32::from(b));
        let within = samples.windows(2).map(|pair| step(pair[0], pair[1])).max();
        let seam = step(samples[0], samples[samples.len() - 1]);
        assert!(Some(seam) <= within, "{seam} {within:?}");
    }

    /// The share of the energy of some samples that lies below a frequency in Hz.
    fn share_below(samples: &[f32], frequency: f64) -> f64 {
        // One tone every 40 Hz up to 12 kHz is fine enough for modes tens of hertz wide.
        let power = |tone: f64| {
            let (mut sine, mut cosine) = (0.0, 0.0);
            for (i, sample) in samples.iter().enumerate() {
                let turn = std::f64::consts::TAU * tone * i as f64 / f64::from(RATE);
                sine += f64::from(*sample) * libm::sin(turn);
                cosine += f64::from(*sample) * libm::cos(turn);
            }
            sine * sine + cosine * cosine
        };
        let tones = (1..300).map(|i| 40.0 * f64::from(i));
        let (mut low, mut all) = (0.0, 0.0);
        for tone in tones {
            let power = power(tone);
            all += power;
            if tone < frequency {
                low += power;
            }
        }
        low / all
    }

    #[test]
    fn balls_click_high_and_cushions_and_pockets_thud_low() {
        let share = |sound, frequency| share_below(&samples(sound, 1)[..4410], frequency);
        assert!(share(Sound::Balls, 1500.0) < 0.05);
        assert!(share(Sound::Cushion, 500.0) > 0.9);
        assert!(share(Sound::Pocket, 1000.0) > 0.9);
        let tip = share(Sound::Tip, 1000.0);
        assert!(share(Sound::Balls, 1000.0) < tip && tip < share(Sound::Cushion, 1000.0));
    }

    #[test]
    fn a_ball_that_comes_back_runs_louder_and_louder_and_ends_in_a_knock() {
        let bytes = ball_return().expect("memory can be written");
        let reader = hound::WavReader::new(Cursor::new(bytes)).expect("a WAV file");
        let samples: Vec<f32> = reader
            .into_samples::<i16>()
            .map(|s| f32::from(s.expect("16 bits")) / f32::from(i16::MAX))
            .collect();
        let loudness = |from: f32, until: f32| {
            let part = &samples[(from * RATE as f32) as usize..(until * RATE as f32) as usize];
            (part.iter().map(|s| s * s).sum::<f32>() / part.len() as f32).sqrt()
        };
        assert!(loudness(0.0, 0.1) < 1e-3);
        assert!(loudness(0.3, 0.7) > 0.005 && loudness(1.2, 1.6) > 1.5 * loudness(0.3, 0.7));
        assert!(loudness(1.75, 1.78) > 2.0 * loudness(1.2, 1.6));
        assert!(loudness(2.15, 2.2) < 0.02);
    }

    #[test]
    fn a_harder_hit_sounds_brighter() {
        // Changes of sign a second: a measure of pitch.
        let brightness = |sound, hardness| {
            let samples = samples(sound, hardness);
            samples[..2205]
                .windows(2)
                .filter(|pair| pair[0] * pair[1] < 0.0)
                .count()
        };
        assert!(brightness(Sound::Balls, 2) > brightness(Sound::Cushion, 2));
        for sound in Sound::ALL {
            assert!(brightness(sound, 2) >= brightness(sound, 0), "{sound:?}");
        }
    }
}
