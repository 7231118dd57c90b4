package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

final class VariableTraceTest {
  private final RecordedArm arm = new RecordedArm();
  private final List<String> refusals = new ArrayList<>();
  private final VariableTrace trace =
      new VariableTrace(command -> arm.controller().submit(command), Runnable::run, refusals::add);

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      arm.frames(1);
      trace.frame(arm.controller().state());
    }
  }

  private List<String> traced() {
    return arm.controller().state().traced().names();
  }

  @Test
  void whatIsWantedIsTracedFromTheNextFrameOn() {
    trace.want(List.of("a", "p[2]"));
    frames(1);
    assertEquals(List.of("a", "p[2]"), traced());
    trace.want(List.of());
    frames(1);
    assertEquals(List.of(), traced());
  }

  @Test
  void aControllerThatIsSwitchedOnLaterTracesItToo() {
    trace.want(List.of("a"));
    frames(1);
    arm.restart();
    frames(200);
    assertEquals(List.of("a"), traced());
  }

  @Test
  void tooManyAreToldOnce() {
    trace.want(IntStream.range(0, 70).mapToObj(i -> "v" + i).toList());
    frames(500);
    assertEquals(1, refusals.size());
    assertTrue(refusals.getFirst().contains("at most 64"), refusals.toString());
  }
}
