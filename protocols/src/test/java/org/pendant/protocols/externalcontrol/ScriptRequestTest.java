package org.pendant.protocols.externalcontrol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Installation;
import org.pendant.project.program.ControlScript;
import org.pendant.protocols.ClosedPort;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.protocols.egress.HostPolicy;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
@Tag("slow")
class ScriptRequestTest {
  private static final String SCRIPT = "# HEADER_BEGIN\ndef f():\nend\n# HEADER_END\n\nf()\n";

  /** So much that only what a test is about runs out. */
  private static final Patience LONG = new Patience(50_000, 50_000, 100, 50_000);

  private static final HostPolicy ANYWHERE = new HostPolicy(AllowedHosts.ANY);

  private static ScriptRequest ask(ControlHost host, Patience patience) {
    return new ScriptRequest(ANYWHERE, host, 1000, patience).begin();
  }

  private static String refusal(ScriptRequest request) {
    return assertThrows(NoScript.class, request::await).getMessage();
  }

  private static List<String> texts(List<ControlScript.Line> lines) {
    return lines.stream().map(ControlScript.Line::text).toList();
  }

  @Test
  void aDriverIsAskedByOneLineAndAnswersWithTheScript() throws Exception {
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      Drivers drivers = new Drivers(AllowedHosts.ANY, Optional.empty());
      Installation installation =
          Installation.NONE.with(parts -> parts.controlHost = driver.host());
      ControlScript script = drivers.request(installation, 1).begin().await();
      assertEquals(List.of("request_program"), driver.questions());
      assertEquals(driver.host(), script.from());
      assertEquals(
          List.of("# HEADER_BEGIN", "def f():", "end", "# HEADER_END"), texts(script.header()));
      assertEquals(List.of("", "f()"), texts(script.loop()));
    }
  }

  @Test
  void whoeverIsChosenIsAskedInPlaceOfTheInstallationsHost() throws Exception {
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      Drivers drivers = new Drivers(AllowedHosts.ANY, Optional.of(driver.host()));
      assertEquals(driver.host(), drivers.request(Installation.NONE, 1).begin().await().from());
    }
  }

  @Test
  void aTextThatComesInPiecesIsReadToItsEnd() throws Exception {
    CountDownLatch sent = new CountDownLatch(1);
    try (FakeDriver driver =
        new FakeDriver(
            client -> {
              for (byte each : SCRIPT.getBytes(StandardCharsets.UTF_8)) {
                client.write(each);
                client.flush();
              }
              sent.countDown();
              client.close();
            })) {
      ControlScript script =
          ask(driver.host(), new Patience(50_000, 50_000, 20_000, 50_000)).await();
      assertEquals(List.of("", "f()"), texts(script.loop()));
      assertEquals(0, sent.getCount());
    }
  }

  @Test
  void aTextEndsWhereTheDriverClosesTheConnection() throws Exception {
    try (FakeDriver driver =
        new FakeDriver(
            client -> {
              client.write("halt".getBytes(StandardCharsets.UTF_8));
              client.close();
            })) {
      assertEquals(List.of("halt"), texts(ask(driver.host(), LONG).await().loop()));
    }
  }

  @Test
  void saysThatNobodyAnswers() throws Exception {
    try (ClosedPort closed = new ClosedPort()) {
      ControlHost gone = new ControlHost("127.0.0.1", closed.number());
      assertEquals(
          "External Control: nobody answers at "
              + gone.text()
              + " (connection refused); the driver must be running",
          refusal(ask(gone, LONG)));
    }
  }

  @Test
  void saysThatADriverTakesTheConnectionAndSendsNothing() throws Exception {
    try (FakeDriver silent = new FakeDriver("")) {
      assertEquals(
          "External Control: "
              + silent.host().text()
              + " has sent no script within 0.05 s; the driver must be running",
          refusal(ask(silent.host(), new Patience(50_000, 50, 50, 50_000))));
    }
  }

  @Test
  void anEmptyScriptIsNone() throws Exception {
    try (FakeDriver empty = new FakeDriver(" \n\n")) {
      assertEquals(
          "External Control: " + empty.host().text() + " has sent an empty script",
          refusal(ask(empty.host(), LONG)));
    }
  }

  @Test
  void aScriptThatIsTooLongIsRefused() throws Exception {
    try (FakeDriver endless = new FakeDriver("sync()\n".repeat(1000))) {
      assertEquals(
          "External Control: "
              + endless.host().text()
              + " has sent more than the 1000 bytes that there may be",
          refusal(ask(endless.host(), LONG)));
    }
  }

  @Test
  void theScriptsOfAllNodesOfAProgramAreBoundedTogether() {
    assertEquals(4 << 20, ScriptRequest.largestBytes(1));
    assertEquals(4 << 20, ScriptRequest.largestBytes(4));
    assertEquals(16 << 10, ScriptRequest.largestBytes(1024));
  }

  @Test
  void aDriverThatNeverComesToAnEndIsGivenUp() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    try (FakeDriver endless =
        new FakeDriver(
            client -> {
              try {
                client.write('#');
                var _ = over.await(50, TimeUnit.SECONDS);
              } catch (InterruptedException e) {
                throw new IOException(e);
              }
            })) {
      assertEquals(
          "External Control: "
              + endless.host().text()
              + " has not sent all of its script within 0.1 s",
          refusal(ask(endless.host(), new Patience(50_000, 50_000, 50_000, 100))));
    } finally {
      over.countDown();
    }
  }

  @Test
  void askingCanBeStopped() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    CountDownLatch asked = new CountDownLatch(1);
    try (FakeDriver slow =
        new FakeDriver(
            client -> {
              asked.countDown();
              try {
                var _ = over.await(50, TimeUnit.SECONDS);
              } catch (InterruptedException e) {
                throw new IOException(e);
              }
            })) {
      ScriptRequest request = ask(slow.host(), LONG);
      asked.await();
      request.cancel();
      assertEquals(
          "External Control: stopped while " + slow.host().text() + " was asked for the script",
          refusal(request));
    } finally {
      over.countDown();
    }
  }

  @Test
  void hostsThatAreNotAllowedAreNeitherAskedNorLookedUp() throws Exception {
    HostPolicy hostPolicy =
        new HostPolicy(
            AllowedHosts.parse("10.0.0.0/8"),
            host -> {
              throw new IllegalStateException(host + " was looked up");
            });
    try (FakeDriver driver = new FakeDriver(SCRIPT)) {
      assertEquals(
          "External Control: " + driver.host().text() + " is not among the allowed hosts",
          refusal(new ScriptRequest(hostPolicy, driver.host(), 1000, LONG).begin()));
      assertEquals(List.of(), driver.questions());
      assertEquals(
          "External Control: driver.example.invalid:50002 is not among the allowed hosts",
          refusal(
              new ScriptRequest(
                      hostPolicy, new ControlHost("driver.example.invalid", 50002), 1000, LONG)
                  .begin()));
    }
  }

  @Test
  void saysThatAHostIsNotKnown() {
    HostPolicy.Names nobody =
        host -> {
          throw new UnknownHostException(host);
        };
    assertEquals(
        "External Control: there is no host pc.local, which should send the script",
        refusal(
            new ScriptRequest(
                    new HostPolicy(AllowedHosts.ANY, nobody),
                    new ControlHost("pc.local", 50002),
                    1,
                    LONG)
                .begin()));
  }

  @Test
  void aLookUpWithoutEndIsGivenUp() throws Exception {
    CountDownLatch over = new CountDownLatch(1);
    HostPolicy.Names slow =
        host -> {
          try {
            var _ = over.await(50, TimeUnit.SECONDS);
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
          return new InetAddress[0];
        };
    Patience patience = new Patience(50_000, 50_000, 50_000, 50);
    String said =
        refusal(
            new ScriptRequest(
                    new HostPolicy(AllowedHosts.ANY, slow),
                    new ControlHost("pc.local", 50002),
                    1,
                    patience)
                .begin());
    over.countDown();
    assertTrue(said.endsWith("has not sent all of its script within 0.05 s"), said);
  }
}
