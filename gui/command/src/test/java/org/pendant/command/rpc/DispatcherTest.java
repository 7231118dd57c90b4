package org.pendant.command.rpc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.json.JsonFile;

final class DispatcherTest {
  private static final String INFO = Lines.request("server.info");

  @Test
  void answerHasTheIdOfItsRequest() {
    assertTrue(Lines.last(INFO).startsWith("{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":{"));
    String text = INFO.replace("\"id\":1", "\"id\":\"ä\"");
    assertTrue(Lines.last(text).startsWith("{\"jsonrpc\":\"2.0\",\"id\":\"\\u00E4\""));
  }

  @Test
  void notificationIsNotAnswered() {
    assertEquals(List.of(), Lines.answers("{\"jsonrpc\":\"2.0\",\"method\":\"server.info\"}"));
    assertEquals(List.of(), Lines.answers("{\"jsonrpc\":\"2.0\",\"method\":\"nothing\"}"));
  }

  @Test
  void batchIsAnsweredByABatchWithoutItsNotifications() {
    String list = Lines.request("robot.list");
    assertEquals(
        List.of("[" + "{\"jsonrpc\":\"2.0\",\"id\":1,\"result\":[]}".repeat(1) + "]"),
        Lines.answers("[" + list + ",{\"jsonrpc\":\"2.0\",\"method\":\"server.info\"}]"));
  }

  @Test
  void whatIsNoRequestGetsTheProtocolsRefusal() {
    assertRefused(-32700, "{\"jsonrpc\"");
    assertRefused(-32700, "hello");
    assertRefused(-32700, "{} {}");
    assertRefused(-32700, "[".repeat(100_000));
    assertRefused(-32700, "{\"a\":1,\"a\":2}");
    assertRefused(-32600, "[]");
    assertRefused(-32600, "[" + "1,".repeat(Dispatcher.MAX_BATCH) + "1]");
    assertRefused(-32600, "7");
    assertRefused(-32600, "{}");
    assertRefused(-32600, "{\"jsonrpc\":\"1.0\",\"id\":1,\"method\":\"server.info\"}");
    assertRefused(-32600, "{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"server.info\"}");
    assertRefused(-32600, "{\"jsonrpc\":\"2.0\",\"id\":1e99,\"method\":\"server.info\"}");
    assertRefused(-32600, "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":3}");
    assertRefused(-32601, Lines.request("nothing"));
    assertRefused(-32602, "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"robot.list\",\"params\":[]}");
    assertRefused(-32602, Lines.request("robot.list", "'x':1"));
    assertRefused(-32602, Lines.request("state"));
    assertRefused(-32001, Lines.request("state", "'handle':3"));
  }

  private static void assertRefused(int code, String line) {
    List<String> answers = Lines.answers(line, INFO);
    assertTrue(
        answers.getFirst().contains("\"error\":{\"code\":" + code + ","), answers.toString());
    assertTrue(answers.getLast().contains("\"result\""), "does not continue after " + line);
  }

  @Test
  void unknownMethodIsToldTheNearest() {
    assertTrue(
        Lines.last(Lines.request("program.strat"))
            .contains("there is no method program.strat, did you mean program.start?"));
  }

  @Test
  void faultIsAnsweredWithoutItsTraceAndTold() {
    List<Throwable> faults = new ArrayList<>();
    MethodTable table =
        new MethodTable(
            new Robots(
                words -> {
                  throw RpcFailure.params("none");
                }));
    table.add(
        "broken",
        params -> {
          throw new IllegalStateException("a bug");
        });
    Optional<String> answer =
        new Dispatcher(table, faults::add)
            .answer(ByteBuffer.wrap(Lines.request("broken").getBytes(StandardCharsets.UTF_8)));
    assertEquals(
        Optional.of(
            "{\"jsonrpc\":\"2.0\",\"id\":1,\"error\":{\"code\":-32603,\"message\":\"internal error:"
                + " java.lang.IllegalStateException: a bug\"}}"),
        answer);
    assertEquals(1, faults.size());
  }

  @Test
  void randomBytesGetNothingButJsonAnswers() throws Exception {
    long seed = 20_261_127;
    Random random = new Random(seed);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    String sample =
        Lines.request("advance", "'until':{'digital_out[0]':true,'var:n':{'above':1}}", "'wall':1");
    for (int i = 0; i < 2_000; i++) {
      byte[] line = sample.getBytes(StandardCharsets.UTF_8);
      for (int changes = random.nextInt(6); changes >= 0; changes--) {
        line[random.nextInt(line.length)] = (byte) random.nextInt(256);
      }
      bytes.writeBytes(line);
      bytes.write('\n');
    }
    bytes.writeBytes(INFO.getBytes(StandardCharsets.UTF_8));
    List<String> answers = new Lines().sent(new ByteArrayInputStream(bytes.toByteArray()));
    assertTrue(answers.getLast().contains("\"methods\""), "seed " + seed);
    for (String each : answers) {
      assertFalse(each.contains("internal error"), () -> "seed " + seed + ": " + each);
      JsonFile.read("answer", new ByteArrayInputStream(each.getBytes(StandardCharsets.UTF_8)));
    }
  }
}
