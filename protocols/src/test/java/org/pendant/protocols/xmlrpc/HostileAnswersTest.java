package org.pendant.protocols.xmlrpc;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.external.Pending;
import org.pendant.controller.external.RpcLink;
import org.pendant.script.value.ScriptError;

/** Whatever a server answers, it is a value or an error of the script. */
@Tag("slow")
@Timeout(120)
class HostileAnswersTest {
  private static final String CHUNKED =
      """
      HTTP/1.1 200 OK
      Transfer-Encoding: chunked

      2
      bo
      2
      dy
      0

      """;

  private static final List<String> ANSWERS =
      List.of(
          Xml.value(Xml.struct("a", "<int>1</int>", "b", Xml.struct("c", "<double>2.5</double>"))),
          Xml.value(
              "<array><data><value><i8>5</i8></value><value><boolean>1</boolean></value>"
                  + "<value><base64>AAAA</base64></value><value><nil/></value></data></array>"),
          Xml.value("<dateTime.iso8601>20260101T00:00:00</dateTime.iso8601>"),
          Xml.fault(4, "<string>no &amp; no</string>", ""));

  private static final List<String> PIECES =
      List.of(
          "<value>",
          "</value>",
          "<struct>",
          "</struct>",
          "<member>",
          "</member>",
          "<name>",
          "</name>",
          "<array>",
          "<data>",
          "</data>",
          "</array>",
          "<int>",
          "</int>",
          "<nil/>",
          "<",
          ">",
          "&",
          "&#0;",
          "x",
          "1e999",
          "<!--",
          "<?pi?>",
          "<![CDATA[",
          "]]>",
          "<ex:i8 xmlns:ex=\"http://ws.apache.org/xmlrpc/namespaces/extensions\">");

  private static final class Answers implements Wire {
    private byte[] next = {};

    @Override
    public void probe() {}

    @Override
    public byte[] exchange(byte[] call) {
      return next;
    }

    @Override
    public void close() {}
  }

  @Test
  void mangledXmlIsAValueOrAScriptError() {
    Answers wire = new Answers();
    RpcLink link = new XmlRpcLink(wire, closed -> {});
    for (int seed = 0; seed < 2000; seed++) {
      String answer = mangled(new SplittableRandom(seed));
      wire.next = answer.getBytes(StandardCharsets.UTF_8);
      try {
        Pending pending = link.call("f", List.of());
        while (!pending.over()) {
          Thread.onSpinWait();
        }
        var _ = pending.result();
      } catch (ScriptError e) {
        // as it should be
      } catch (RuntimeException e) {
        throw new AssertionError("seed " + seed + ": " + answer, e);
      }
    }
  }

  private static String mangled(SplittableRandom random) {
    StringBuilder text = new StringBuilder(ANSWERS.get(random.nextInt(ANSWERS.size())));
    for (int i = random.nextInt(5); i >= 0; i--) {
      int from = random.nextInt(text.length());
      switch (random.nextInt(3)) {
        case 0 -> text.insert(from, PIECES.get(random.nextInt(PIECES.size())));
        case 1 -> text.delete(from, Math.min(text.length(), from + random.nextInt(20)));
        default -> text.setCharAt(from, (char) random.nextInt(32, 300));
      }
      if (text.isEmpty()) {
        text.append('x');
      }
    }
    return text.toString();
  }

  private static HttpAnswer read(byte[] bytes, int length) throws IOException {
    return HttpAnswer.read(new ByteArrayInputStream(bytes, 0, length)::read);
  }

  @Test
  void anAnswerThatIsCutAnywhereIsRefused() throws IOException {
    String sized =
        """
        HTTP/1.1 200 OK
        Content-Length: 4
        X: y

        body\
        """;
    for (String text : List.of(sized, "HTTP/1.1 100 Continue\n\n" + CHUNKED)) {
      byte[] bytes = text.getBytes(StandardCharsets.US_ASCII);
      assertArrayEquals(
          "body".getBytes(StandardCharsets.US_ASCII), read(bytes, bytes.length).body());
      for (int cut = 0; cut < bytes.length; cut++) {
        int length = cut;
        assertThrows(IOException.class, () -> read(bytes, length), () -> text + " at " + length);
      }
    }
  }

  @Test
  void mangledHttpIsAnAnswerOrRefused() {
    for (int seed = 0; seed < 20_000; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      byte[] bytes = CHUNKED.getBytes(StandardCharsets.US_ASCII);
      for (int i = random.nextInt(6); i >= 0; i--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
      }
      try {
        var _ = read(bytes, bytes.length).body();
      } catch (IOException e) {
        // as it should be
      } catch (RuntimeException e) {
        throw new AssertionError("seed " + seed, e);
      }
    }
  }
}
