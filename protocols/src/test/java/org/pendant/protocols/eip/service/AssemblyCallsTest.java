package org.pendant.protocols.eip.service;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.eip.AssemblyPair;

class AssemblyCallsTest {
  private static final long SEED = 20_261_122;

  private final List<AssemblyPair> added = new ArrayList<>();
  private final AssemblyCalls calls =
      new AssemblyCalls(
          new Configuration() {
            @Override
            public boolean add(AssemblyPair pair) {
              return added.isEmpty() && added.add(pair);
            }

            @Override
            public boolean connected(int fromScanner) {
              return fromScanner == 111;
            }
          });

  private String answer(String xml) throws InterruptedException {
    return calls.answer(ByteBuffer.wrap(xml.getBytes(StandardCharsets.UTF_8)));
  }

  private String call(String method, String... values) throws InterruptedException {
    StringBuilder xml = new StringBuilder("<methodCall><methodName>" + method + "</methodName>");
    xml.append("<params>");
    for (String value : values) {
      xml.append("<param><value>").append(value).append("</value></param>");
    }
    return answer(xml.append("</params></methodCall>").toString());
  }

  private static String number(int value) {
    return "<int>" + value + "</int>";
  }

  private static void assertBool(boolean expected, String answer) {
    assertTrue(answer.contains("<boolean>" + (expected ? 1 : 0) + "</boolean>"), answer);
  }

  @Test
  void addsAPairAndTellsWhenThatIsRefused() throws InterruptedException {
    String[] pair = {number(101), number(88), number(111), number(44)};
    assertBool(true, call("add_configuration", pair));
    assertEquals(List.of(new AssemblyPair(101, 88, 111, 44)), added);
    assertBool(false, call("add_configuration", pair));
  }

  @ParameterizedTest
  @CsvSource({
    "100, 88, 111, 44",
    "101, 88, 112, 44",
    "1, 88, 111, 44",
    "101, 0, 111, 44",
    "101, 88, 111, 1401",
    "101, 88, 101, 88",
    "0, 88, 111, 44",
    "101, 88, 65536, 44"
  })
  void answersFalseToParametersThatCannotBe(int to, int toBytes, int from, int fromBytes)
      throws InterruptedException {
    assertBool(
        false,
        call("add_configuration", number(to), number(toBytes), number(from), number(fromBytes)));
    assertEquals(List.of(), added);
  }

  @Test
  void answersFalseToParametersOfOtherTypes() throws InterruptedException {
    assertBool(false, call("add_configuration"));
    assertBool(
        false, call("add_configuration", "<string>x</string>", number(1), number(2), number(3)));
  }

  @Test
  void tellsWhetherAScannerIsConnected() throws InterruptedException {
    assertBool(true, call("is_instance_connected", number(111)));
    assertBool(false, call("is_instance_connected", number(112)));
    assertTrue(call("is_instance_connected").contains("<i4>3</i4>"));
  }

  @Test
  void otherMethodsAndWhatIsNoCallAreFaults() throws InterruptedException {
    assertTrue(call("system.exec").contains("<i4>2</i4>"));
    assertTrue(answer("").contains("<i4>1</i4>"));
    assertTrue(answer("<a>").contains("<i4>1</i4>"));
    assertTrue(answer("<methodCall></methodCall>").contains("<i4>1</i4>"));
    assertTrue(
        answer("<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/hostname'>]><methodCall/>")
            .contains("<i4>1</i4>"));
    assertTrue(
        answer(
                "<methodCall><methodName>a</methodName><params><param><value>"
                    + "<array><data><value>".repeat(100))
            .contains("<i4>1</i4>"));
  }

  @Test
  void anyChangeOfACallIsAnswered() throws InterruptedException {
    String right =
        "<?xml version='1.0'?><methodCall><methodName>add_configuration</methodName><params>"
            + "<param><value><i4>1</i4></value></param><param><value>x</value></param><param>"
            + "<value><double>1.5</double></value></param><param><value><struct><member><name>a"
            + "</name><value><array><data><value><boolean>1</boolean></value></data></array>"
            + "</value></member></struct></value></param></params></methodCall>";
    assertBool(false, answer(right));
    String[] parts = right.split("(?=<)");
    Random random = new Random(SEED);
    for (int i = 0; i < 5000; i++) {
      String[] changed = parts.clone();
      for (int j = random.nextInt(1, 4); j > 0; j--) {
        changed[random.nextInt(1, parts.length)] =
            random.nextBoolean() ? "" : parts[random.nextInt(1, parts.length)];
      }
      String call = String.join("", changed);
      assertTrue(answer(call).endsWith("</methodResponse>"), call);
    }
  }
}
