package org.pendant.recording;

import java.util.List;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.script.debug.DebugState;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Memory estimate of a recorded object; rather too high than too low. Parts shared with the
 * previous object count once.
 */
final class MemoryEstimate {
  /** In place of what was there before: all of a value counts. */
  static final Object NOTHING = List.of();

  private static final int OBJECT = 64;
  private static final int REFERENCE = 8;
  private static final int SIGNALS = 1500;

  private MemoryEstimate() {}

  /**
   * Bytes that {@code value} takes in place of {@code before}.
   *
   * @param before what was there before, or {@link #NOTHING}
   */
  static long of(Object value, Object before) {
    return switch (value) {
      case VariableSamples samples -> samples(samples, before);
      case TracedVariables traced -> OBJECT + (long) Double.BYTES * traced.names().size();
      case FrameDelta frameDelta ->
          OBJECT * (4L + frameDelta.events().size())
              + list(frameDelta.entries())
              + list(frameDelta.popups())
              + list(frameDelta.questions());
      case List<?> list -> list(list);
      case DebugState debug -> debug(debug);
      case SignalState signals -> SIGNALS;
      case AssemblyImage image -> assemblies(image);
      default -> 2 * OBJECT;
    };
  }

  private static long list(List<?> list) {
    long sum = OBJECT;
    for (Object each : list) {
      sum +=
          OBJECT
              + switch (each) {
                case LogEntry entry -> OBJECT + entry.text().length();
                case Popup popup -> OBJECT + popup.text().length() + popup.title().length();
                case Question question -> OBJECT + question.text().length();
                case ModbusSignalState signal -> OBJECT + REFERENCE * signal.values().size();
                default -> OBJECT;
              };
    }
    return sum;
  }

  private static long debug(DebugState debug) {
    long sum = OBJECT;
    for (ThreadSnapshot each : debug.threads()) {
      sum += (long) OBJECT * (1 + each.stack().size());
    }
    return sum;
  }

  private static long assemblies(AssemblyImage image) {
    long sum = OBJECT;
    for (AssemblyData each : image.toPlc().values()) {
      sum += OBJECT + each.size();
    }
    for (AssemblyData each : image.fromPlc().values()) {
      sum += OBJECT + each.size();
    }
    return sum;
  }

  private static long samples(VariableSamples now, Object before) {
    VariableSamples old =
        before instanceof VariableSamples samples ? samples : VariableSamples.NONE;
    return OBJECT + changed(now.globals(), old.globals()) + changed(now.locals(), old.locals());
  }

  private static long changed(List<VariableSample> now, List<VariableSample> before) {
    long sum = OBJECT + (long) REFERENCE * now.size();
    for (int i = 0; i < now.size(); i++) {
      VariableSample each = now.get(i);
      if (i >= before.size() || each != before.get(i)) {
        sum += OBJECT + each.bytes();
      }
    }
    return sum;
  }
}
