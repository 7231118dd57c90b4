package org.pendant.editors.dap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.editors.dap.DebugClient.refusal;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.Map;
import java.util.stream.StreamSupport;
import org.eclipse.lsp4j.debug.ContinuedEventArguments;
import org.eclipse.lsp4j.debug.StoppedEventArguments;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LiveRobotRequestsTest {
  private static final String WORK =
      """
      i = 0
      while i < 10:
        i = i + 1
        set_standard_digital_out(2, i > 3)
        textmsg("turn ", i)
        sleep(0.1)
      end
      sleep(0.1)
      """;

  @TempDir private Path folder;

  private DebugClient stopped() throws Exception {
    DebugClient client = DebugClient.of(folder, WORK);
    client.launch(Map.of("robot", "ur10e"));
    var _ = client.breakpoints(8);
    client.configured();
    client.stop();
    return client;
  }

  private static String value(JsonObject robot, String list, String name) {
    return StreamSupport.stream(robot.getAsJsonArray(list).spliterator(), false)
        .map(JsonElement::getAsJsonObject)
        .filter(each -> each.get("name").getAsString().equals(name))
        .map(each -> each.get("value").getAsString())
        .findFirst()
        .orElseThrow();
  }

  private static JsonObject robot(DebugClient client, Map<String, Object> asked) {
    return client.server().robot(asked).join();
  }

  @Test
  void theRobotIsToldWhileItsProgramRuns() throws Exception {
    try (DebugClient client = DebugClient.of(folder, "while True:\n  sync()\nend\n")) {
      client.launch();
      client.configured();
      JsonObject robot = robot(client, Map.of());
      assertEquals("running", robot.get("state").getAsString());
      assertTrue(value(robot, "robot", "actual_q").startsWith("["));
      client.server().setSignal(Map.of("bank", "digital_in", "index", 3, "on", true)).join();
      assertEquals(
          "[False, False, False, True, False, False, False, False]",
          value(robot(client, Map.of()), "signals", "digital_in"));
    }
  }

  @Test
  void anEarlierTimeIsLookedAtWithoutGoingThere() throws Exception {
    try (DebugClient client = stopped()) {
      JsonObject now = robot(client, Map.of());
      assertEquals("stopped", now.get("state").getAsString());
      assertEquals("1.002 s", value(now, "robot", "time"));
      assertEquals(0, now.get("fromS").getAsDouble());
      JsonObject earlier = robot(client, Map.of("timeS", 0.2));
      assertEquals(0.2, earlier.get("timeS").getAsDouble());
      assertEquals(1.002, earlier.get("nowS").getAsDouble());
      assertTrue(value(earlier, "signals", "digital_out").startsWith("[False, False, False"));
      assertEquals("10", client.evaluate("i", "watch"));
    }
  }

  @Test
  void theDebuggerGoesToATimeAndBackToNow() throws Exception {
    try (DebugClient client = stopped()) {
      client.server().goToTime(Map.of("timeS", 0.25)).join();
      client.next(ContinuedEventArguments.class);
      StoppedEventArguments stop = client.stop();
      assertEquals("In the past, at 0.250 s; now is 1.002 s", stop.getDescription());
      assertEquals("3", client.evaluate("i", "watch"));
      assertEquals("past", robot(client, Map.of()).get("state").getAsString());
      assertEquals(
          "the past cannot be changed: continue to now first",
          refusal(
              client.server().setSignal(Map.of("bank", "digital_out", "index", 0, "on", true))));
      client.server().goToTime(Map.of("timeS", 99)).join();
      assertEquals("Back to now", client.stop().getDescription());
      assertEquals(
          "timeS is missing, robot time in s", refusal(client.server().goToTime(Map.of())));
    }
  }

  @Test
  void outputsAreSwitchedWhereTheProgramStands() throws Exception {
    try (DebugClient client = stopped()) {
      client.server().setSignal(Map.of("bank", "digital_out", "index", 0, "on", true)).join();
      assertEquals("True", client.evaluate("get_standard_digital_out(0)", "watch"));
      assertTrue(
          value(robot(client, Map.of()), "signals", "digital_out")
              .startsWith("[True, False, True"));
      assertEquals(
          "bank is unknown, must be such as digital_out",
          refusal(client.server().setSignal(Map.of("bank", "lamp", "index", 0, "on", true))));
    }
  }

  @Test
  void onlyOutputThatIsNewIsToldWhereThatIsAskedFor() throws Exception {
    try (DebugClient client = stopped()) {
      int last =
          client
              .server()
              .moments(Map.of())
              .join()
              .getAsJsonArray("moments")
              .get(9)
              .getAsJsonObject()
              .get("id")
              .getAsInt();
      assertEquals(
          1,
          client
              .server()
              .moments(Map.of("after", last - 1))
              .join()
              .getAsJsonArray("moments")
              .size());
    }
  }
}
