package org.pendant.recording;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Set;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/** Whether two snapshots say the same, with every bit. */
final class SameState {
  /** What follows from others or is not kept, or never changes and has no equality. */
  private static final Set<String> LEFT_OUT =
      Set.of("geometry", "kinematics", "behindS", "armRests");

  /** What never rests, and is kept once a second only while nothing else changes. */
  private static final Set<String> AMBIENT =
      Set.of(
          "executionTimeS",
          "temperatureC",
          "toolTemperatureC",
          "controllerTemperatureC",
          "energyConsumedJ",
          "energyDissipatedJ");

  private SameState() {}

  static void assertSame(ControllerState wanted, ControllerState found) {
    compare("frame " + wanted.frame(), wanted, found, false);
    assertEquals(
        wanted.geometry().actualTcpInBase(), found.geometry().actualTcpInBase(), "kinematics");
  }

  /** As {@link #assertSame}, but for temperatures, energies and execution times. */
  static void assertSameButAmbient(ControllerState wanted, ControllerState found) {
    compare("frame " + wanted.frame(), wanted, found, true);
  }

  private static void compare(String what, Record wanted, Record found, boolean butAmbient) {
    for (RecordComponent each : wanted.getClass().getRecordComponents()) {
      String name = each.getName();
      if (LEFT_OUT.contains(name) || (butAmbient && AMBIENT.contains(name))) {
        continue;
      }
      String here = what + " " + name;
      Object one = value(each, wanted);
      Object other = value(each, found);
      if (name.equals("arm") || name.equals("readings")) {
        compare(here, (Record) one, (Record) other, butAmbient);
      } else if (one instanceof VariableSamples samples) {
        VariableSamples others = (VariableSamples) other;
        assertEquals(samples.run(), others.run(), here);
        assertEquals(samples.mainFunction(), others.mainFunction(), here);
        assertEquals(samples.omitted(), others.omitted(), here);
        assertEquals(words(samples.globals()), words(others.globals()), here);
        assertEquals(words(samples.locals()), words(others.locals()), here);
      } else if (one instanceof TracedVariables traced) {
        TracedVariables others = (TracedVariables) other;
        assertEquals(traced.names(), others.names(), here);
        for (int i = 0; i < traced.names().size(); i++) {
          assertEquals(traced.value(i), others.value(i), here);
        }
      } else if (one instanceof LogLines lines) {
        assertEquals(lines.entries(), ((LogLines) other).entries(), here);
      } else {
        assertEquals(one, other, here);
      }
    }
  }

  private static List<List<Object>> words(List<VariableSample> samples) {
    return samples.stream()
        .map(each -> List.<Object>of(each.name(), each.expression(), each.value(), each.length()))
        .toList();
  }

  private static Object value(RecordComponent component, Record record) {
    try {
      return component.getAccessor().invoke(record);
    } catch (ReflectiveOperationException e) {
      throw new LinkageError(component.getName(), e);
    }
  }
}
