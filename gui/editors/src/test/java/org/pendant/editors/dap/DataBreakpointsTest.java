package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.DataBreakpoint;
import org.eclipse.lsp4j.debug.DataBreakpointInfoArguments;
import org.eclipse.lsp4j.debug.DataBreakpointInfoResponse;
import org.eclipse.lsp4j.debug.SetDataBreakpointsArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.eclipse.lsp4j.debug.Variable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DataBreakpointsTest {
  private static final String CHANGES =
      """
      def f(x):
        sleep(0.01)
        return x
      end
      count = 0
      sleep(0.1)
      while True:
        count = f(count + 1)
        set_standard_digital_out(2, count == 3)
        sleep(0.1)
      end
      """;

  @TempDir private Path folder;

  private DebugClient stopped(int line) throws Exception {
    DebugClient client = DebugClient.of(folder, CHANGES);
    client.launch();
    var _ = client.breakpoints(line);
    client.configured();
    client.stop();
    var _ = client.breakpoints(new int[0]);
    return client;
  }

  private static DataBreakpointInfoResponse info(DebugClient client, int reference, String name) {
    DataBreakpointInfoArguments arguments = new DataBreakpointInfoArguments();
    arguments.setVariablesReference(reference == 0 ? null : reference);
    arguments.setName(name);
    return client.server().dataBreakpointInfo(arguments).join();
  }

  private static DataBreakpoint on(DataBreakpointInfoResponse info) {
    DataBreakpoint wanted = new DataBreakpoint();
    wanted.setDataId(info.getDataId());
    return wanted;
  }

  private static Breakpoint[] set(DebugClient client, DataBreakpoint... wanted) {
    SetDataBreakpointsArguments arguments = new SetDataBreakpointsArguments();
    arguments.setBreakpoints(wanted);
    return client.server().setDataBreakpoints(arguments).join().getBreakpoints();
  }

  @Test
  void aProgramStopsWhenAVariableHasChanged() throws Exception {
    try (DebugClient client = stopped(6)) {
      int globals = client.scopes().get("Globals").getVariablesReference();
      Breakpoint[] told = set(client, on(info(client, globals, "count")));
      client.resume();
      StoppedEventArguments stop = client.stop();
      assertEquals("data breakpoint", stop.getReason());
      assertEquals("count changed from 0 to 1", stop.getDescription());
      assertEquals(List.of(told[0].getId()), List.of(stop.getHitBreakpointIds()));
      client.resume();
      assertEquals("count changed from 1 to 2", client.stop().getDescription());
    }
  }

  @Test
  void aConditionAndHitsDecideWhetherAChangeCounts() throws Exception {
    try (DebugClient client = stopped(6)) {
      DataBreakpoint wanted = on(info(client, 0, "count"));
      wanted.setCondition("count > 3");
      wanted.setHitCondition("2");
      var _ = set(client, wanted);
      client.resume();
      assertEquals("count changed from 4 to 5", client.stop().getDescription());
    }
  }

  @Test
  void signalsAreWatched() throws Exception {
    try (DebugClient client = stopped(6)) {
      int signals = client.scopes().get("I/O").getVariablesReference();
      Variable outputs =
          client.variables(signals).stream()
              .filter(each -> each.getName().equals("digital_out"))
              .findFirst()
              .orElseThrow();
      var _ = set(client, on(info(client, outputs.getVariablesReference(), "[2]")));
      client.resume();
      assertEquals("digital_out[2] changed from False to True", client.stop().getDescription());
      assertEquals("3", client.evaluate("count", "watch"));
    }
  }

  @Test
  void expressionsAreWatched() throws Exception {
    try (DebugClient client = stopped(6)) {
      var _ = set(client, on(info(client, 0, "count * 2 > 5")));
      client.resume();
      assertEquals("count * 2 > 5 changed from False to True", client.stop().getDescription());
      assertEquals("3", client.evaluate("count", "watch"));
    }
  }

  @Test
  void aProgramStopsWhenThereIsAValueAndWhenThereIsNoneAnyMore() throws Exception {
    String program =
        """
        count = 0
        sleep(0.1)
        parts = [10, 20]
        while True:
          sleep(0.1)
          count = count + 1
        end
        """;
    try (DebugClient client = DebugClient.of(folder, program)) {
      client.launch();
      var _ = client.breakpoints(2);
      client.configured();
      client.stop();
      DataBreakpoint part = new DataBreakpoint();
      part.setDataId("value:parts[count]");
      var _ = set(client, part);
      client.resume();
      assertEquals("parts[count] changed from no value to 10", client.stop().getDescription());
      client.resume();
      assertEquals("parts[count] changed from 10 to 20", client.stop().getDescription());
      client.resume();
      assertEquals("parts[count] changed from 20 to no value", client.stop().getDescription());
    }
  }

  @Test
  void whatPeopleChangeThemselvesStopsNothing() throws Exception {
    try (DebugClient client = stopped(6)) {
      var _ = set(client, on(info(client, 0, "count")));
      client.stepOver();
      client.stop();
      assertEquals("40", client.evaluate("count = 40", "repl"));
      client.resume();
      assertEquals("count changed from 40 to 41", client.stop().getDescription());
    }
  }

  @Test
  void localVariablesAndNonsenseAreNotWatched() throws Exception {
    try (DebugClient client = stopped(2)) {
      int locals = client.scopes().get("Locals").getVariablesReference();
      DataBreakpointInfoResponse info = info(client, locals, "x");
      assertNull(info.getDataId());
      assertEquals(
          "x cannot be watched, only global variables, their parts and what the robot has can",
          info.getDescription());
      assertNull(info(client, 0, "nothing").getDataId());
      DataBreakpoint unknown = new DataBreakpoint();
      unknown.setDataId("elsewhere");
      assertEquals(
          List.of("there is no value elsewhere"),
          Arrays.stream(set(client, unknown)).map(Breakpoint::getMessage).toList());
    }
  }
}
