package org.pendant.protocols.externalcontrol;

import static org.pendant.protocols.externalcontrol.ExternalControlTexts.text;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.pendant.controller.installation.ControlHost;
import org.pendant.project.program.ControlScript;
import org.pendant.protocols.egress.HostNotAllowed;
import org.pendant.protocols.egress.HostPolicy;

/**
 * Script request to a driver, in a thread of its own, so that the thread that waits for the answer
 * can be told to wait no more. The driver is sent a line and answers with the text; that it has
 * ended shows by silence, as drivers keep the connection open.
 */
public final class ScriptRequest {
  private static final byte[] LINE = "request_program\n".getBytes(StandardCharsets.US_ASCII);

  /** That of the driver for ROS has 50 kB. */
  private static final int MAX_BYTES = 4 << 20;

  /** In all nodes of a program together. */
  private static final int MAX_TOTAL_BYTES = 16 << 20;

  private static final int CHUNK_BYTES = 16 << 10;

  private final HostPolicy hostPolicy;
  private final ControlHost host;
  private final int largestBytes;
  private final Patience patience;
  private final FutureTask<ControlScript> task = new FutureTask<>(this::ask);

  ScriptRequest(HostPolicy hostPolicy, ControlHost host, int largestBytes, Patience patience) {
    this.hostPolicy = hostPolicy;
    this.host = host;
    this.largestBytes = largestBytes;
    this.patience = patience;
  }

  /**
   * Begins to ask, once; does not wait, and answers this request. No driver is asked after {@link
   * #cancel}: a caller that may be told to stop makes the request known first.
   */
  public ScriptRequest begin() {
    Thread.ofVirtual().name("script of " + host.text()).start(task);
    return this;
  }

  /** How large a script may be that stands in a program {@code nodes} times. */
  static int largestBytes(int nodes) {
    return Math.min(MAX_BYTES, MAX_TOTAL_BYTES / Math.max(1, nodes));
  }

  /** Who is asked. */
  public ControlHost host() {
    return host;
  }

  /**
   * Asks no longer; the thread that waits is told so. Nothing happens when the script has come
   * already.
   */
  public void cancel() {
    var _ = task.cancel(true);
  }

  /**
   * Waits for the script, not much longer than 10 s.
   *
   * @throws NoScript if there is none, and why
   * @throws InterruptedException if the waiting thread is interrupted; no driver is asked any
   *     longer
   */
  public ControlScript await() throws NoScript, InterruptedException {
    try {
      return task.get(patience.longestMs(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof NoScript none) {
        throw none;
      }
      throw new IllegalStateException("asking " + host.text() + " has failed", e.getCause());
    } catch (TimeoutException e) {
      throw none(text("notAllSentWithin", host.text(), seconds(patience.longestMs())));
    } catch (CancellationException e) {
      throw none(text("stoppedWhileAsked", host.text()));
    } finally {
      cancel();
    }
  }

  private static NoScript none(String why) {
    return new NoScript(text("externalControl", why));
  }

  private static String seconds(int ms) {
    return ms / 1000.0 + " s";
  }

  private ControlScript ask() throws NoScript {
    try (Socket socket = connected()) {
      socket.getOutputStream().write(LINE);
      String text = new String(read(socket), StandardCharsets.UTF_8);
      if (text.isBlank()) {
        throw none(text("emptyScript", host.text()));
      }
      return ControlScript.of(host, text);
    } catch (IOException e) {
      throw none(text("connectionBrokeOff", host.text(), e.getMessage()));
    }
  }

  private Socket connected() throws NoScript {
    try {
      return hostPolicy.connect(host.host(), host.port(), patience.connectMs());
    } catch (HostNotAllowed e) {
      throw none(text("hostNotAllowed", host.text()));
    } catch (UnknownHostException e) {
      throw none(text("noSuchHost", host.host()));
    } catch (IOException e) {
      throw none(text("nobodyAnswers", host.text(), e.getMessage()));
    }
  }

  private byte[] read(Socket socket) throws IOException, NoScript {
    ByteArrayOutputStream text = new ByteArrayOutputStream();
    byte[] chunk = new byte[CHUNK_BYTES];
    InputStream in = socket.getInputStream();
    boolean whole = false;
    while (text.size() <= largestBytes) {
      socket.setSoTimeout(whole ? patience.quietMs() : patience.answerMs());
      int count;
      try {
        count = in.read(chunk);
      } catch (SocketTimeoutException e) {
        if (text.size() == 0) {
          throw none(text("nothingSentWithin", host.text(), seconds(patience.answerMs())));
        }
        return text.toByteArray();
      }
      if (count < 0) {
        return text.toByteArray();
      }
      text.write(chunk, 0, count);
      whole = chunk[count - 1] == '\n';
    }
    throw none(text("sentTooMuch", host.text(), largestBytes));
  }
}
