package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.encoder.CountRange;
import org.pendant.controller.encoder.Encoder;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.encoder.PulseDecoder;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Encoders of conveyors (manual 15.1, 15.3 to 15.7, 15.20, 15.45). */
final class EncoderBuiltins {
  private static final String MODULE = "motion";

  /** The inputs that can be decoded have these numbers; the first is configurable input 0. */
  private static final int FIRST_PIN = 8;

  private static final int LAST_PIN = 11;

  private static final int LAST_OLD_PIN = 3;

  private static final int LAST_RANGE = CountRange.values().length - 1;

  private static final int QUADRATURE = 1;
  private static final int LAST_DECODER = PulseDecoder.Kind.values().length;

  private EncoderBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareSetUp(builtins);
    declareCounts(builtins);
    declareDeprecated(builtins);
  }

  private static void declareSetUp(Builtins<ControlBox> builtins) {
    builtins
        .declare("encoder_enable_pulse_decode")
        .manual(MODULE, "15.3")
        .doc(
            "Counts the pulses of inputs with encoder 0 or 1. decoder_type is 0 for none, 1 for a"
                + " quadrature signal on A and B, 2 for both edges of A, 3 for its rising and 4 for"
                + " its falling edge; inputs 8 to 11 are configurable_in[0] to [3].")
        .needs("encoder_index", Type.INT)
        .needs("decoder_type", Type.INT)
        .needs("A", Type.INT)
        .needs("B", Type.INT)
        .does(EncoderBuiltins::enablePulses);
    builtins
        .declare("encoder_enable_set_tick_count")
        .manual(MODULE, "15.4")
        .doc(
            "Makes encoder 0 or 1 take the counts of encoder_set_tick_count. range_id says how they"
                + " wrap: 0 at 32 bits with a sign, 1 at 8 bits, 2 at 16, 3 at 24, 4 at 32"
                + " without.")
        .needs("encoder_index", Type.INT)
        .needs("range_id", Type.INT)
        .does(EncoderBuiltins::enableCounts);
  }

  private static void declareCounts(Builtins<ControlBox> builtins) {
    builtins
        .declare("encoder_get_tick_count")
        .manual(MODULE, "15.5")
        .doc(
            "The filtered count of encoder 0 or 1, from 0 to below 65536 where it wraps; with"
                + " opt=\"raw\" the count itself, an int of 32 bits.")
        .needs("encoder_index", Type.INT)
        .takes("opt", Type.STRING, Value.of(""))
        .returns(Type.NUMBER)
        .effect(Effect.SENSES)
        .does(EncoderBuiltins::count);
    builtins
        .declare("encoder_set_tick_count")
        .manual(MODULE, "15.6")
        .doc(
            "Tells the count of encoder 0 or 1, which encoder_enable_set_tick_count must have made"
                + " ready for it; the belt has gone there the shorter way round.")
        .needs("encoder_index", Type.INT)
        .needs("count", Type.NUMBER)
        .does(EncoderBuiltins::setCount);
    builtins
        .declare("encoder_unwind_delta_tick_count")
        .manual(MODULE, "15.7")
        .doc(
            "A difference of two counts without the jump of a wrap between them; nothing if the"
                + " encoder is not enabled.")
        .needs("encoder_index", Type.INT)
        .needs("delta_tick_count", Type.NUMBER)
        .returns(Type.ANY)
        .does(EncoderBuiltins::unwind);
  }

  private static void declareDeprecated(Builtins<ControlBox> builtins) {
    builtins
        .declare("conveyor_pulse_decode")
        .manual(MODULE, "15.1")
        .doc(
            "Counts the pulses of digital inputs 0 to 3 with encoder 0; types as for"
                + " encoder_enable_pulse_decode.")
        .needs("type", Type.INT)
        .needs("A", Type.INT)
        .mayTake("B", Type.INT, Unit.NONE, "no input; needed for type 1")
        .deprecated("encoder_enable_pulse_decode")
        .does(EncoderBuiltins::oldPulses);
    builtins
        .declare("get_conveyor_tick_count")
        .manual(MODULE, "15.20")
        .doc("The filtered count of encoder 0.")
        .returns(Type.NUMBER)
        .deprecated("encoder_get_tick_count")
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().offsets().encoders().get(0).filteredCount()));
    builtins
        .declare("set_conveyor_tick_count")
        .manual(MODULE, "15.45")
        .doc(
            "Tells the count of encoder 0; the resolution is the range_id of"
                + " encoder_enable_set_tick_count.")
        .needs("tick_count", Type.NUMBER)
        .takes("absolute_encoder_resolution", Type.INT, Value.of(0))
        .deprecated("encoder_set_tick_count")
        .does(EncoderBuiltins::oldSetCount);
  }

  /** The encoder that argument {@code index} names. */
  static Encoder encoder(Call<ControlBox> call, int index) throws ScriptError {
    return call.host().offsets().encoders().get(call.integer(index, 0, Encoders.COUNT - 1));
  }

  private static Outcome enablePulses(Call<ControlBox> call) throws ScriptError {
    Encoder encoder = encoder(call, 0);
    int type = call.integer(1, 0, LAST_DECODER);
    int a = call.integer(2, FIRST_PIN, LAST_PIN) - FIRST_PIN;
    int b = call.integer(3, FIRST_PIN, LAST_PIN) - FIRST_PIN;
    if (type == QUADRATURE && a == b) {
      throw call.refuse(3, text("otherInputThanA"));
    }
    decode(call.host(), encoder, type, SignalBank.CONFIGURABLE_IN, a, b);
    return call.answer();
  }

  private static Outcome oldPulses(Call<ControlBox> call) throws ScriptError {
    int type = call.integer(0, 0, LAST_DECODER);
    int a = call.integer(1, 0, LAST_OLD_PIN);
    boolean quadrature = type == QUADRATURE;
    if (quadrature && !call.given(2)) {
      throw call.failure("missing-argument", text("quadratureWithoutB"));
    }
    // the manual's example of a decoder on one input leaves B out
    int b = call.given(2) ? call.integer(2, 0, LAST_OLD_PIN) : a;
    if (quadrature && a == b) {
      throw call.refuse(2, text("otherInputThanA"));
    }
    decode(
        call.host(), call.host().offsets().encoders().get(0), type, SignalBank.STANDARD_IN, a, b);
    return call.answer();
  }

  private static void decode(
      ControlBox box, Encoder encoder, int type, SignalBank bank, int a, int b) {
    if (type == 0) {
      encoder.disable();
    } else {
      PulseDecoder.Kind kind = PulseDecoder.Kind.of(type);
      encoder.decode(
          new PulseDecoder(kind, new Signal(bank, a), new Signal(bank, b)),
          box.signals().digital());
    }
  }

  private static Outcome enableCounts(Call<ControlBox> call) throws ScriptError {
    Encoder encoder = encoder(call, 0);
    encoder.expectCounts(CountRange.of(call.integer(1, 0, LAST_RANGE)));
    return call.answer();
  }

  private static Outcome count(Call<ControlBox> call) throws ScriptError {
    Encoder encoder = encoder(call, 0);
    return switch (call.word(1)) {
      case "" -> call.answer(encoder.filteredCount());
      case "raw" -> call.answerInt(encoder.rawCount());
      default -> throw call.refuse(1, text("emptyOrRaw"));
    };
  }

  private static Outcome setCount(Call<ControlBox> call) throws ScriptError {
    Encoder encoder = encoder(call, 0);
    Optional<CountRange> range = encoder.toldRange();
    if (range.isEmpty()) {
      throw call.failure("encoder-not-enabled", text("encoderTakesNoCounts", call.integer(0)));
    }
    encoder.tell(countIn(call, 1, range.get()));
    return call.answer();
  }

  private static Outcome oldSetCount(Call<ControlBox> call) throws ScriptError {
    CountRange range = CountRange.of(call.integer(1, 0, LAST_RANGE));
    long count = countIn(call, 0, range);
    Encoder encoder = call.host().offsets().encoders().get(0);
    if (!encoder.toldRange().equals(Optional.of(range))) {
      encoder.expectCounts(range);
    }
    encoder.tell(count);
    return call.answer();
  }

  private static long countIn(Call<ControlBox> call, int index, CountRange range)
      throws ScriptError {
    double count = call.number(index);
    if (count != Math.rint(count)) {
      throw call.refuse(index, text("whole"));
    }
    if (!(count >= range.lowest() && count <= range.highest())) {
      throw call.refuse(index, text("range", range.lowest(), range.highest()));
    }
    return (long) count;
  }

  private static Outcome unwind(Call<ControlBox> call) throws ScriptError {
    Encoder encoder = encoder(call, 0);
    double difference = call.number(1);
    if (!Double.isFinite(difference)) {
      throw call.refuse(1, text("finite"));
    }
    Optional<Double> unwound = encoder.unwound(difference);
    return unwound.isPresent() ? call.answer(unwound.get()) : call.answer();
  }
}
