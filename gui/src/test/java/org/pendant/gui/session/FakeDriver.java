package org.pendant.gui.session;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicInteger;
import org.pendant.controller.installation.ControlHost;

/** A driver on this computer: sends its script to everybody who sends a line. */
public final class FakeDriver implements AutoCloseable {
  private final ServerSocket server;
  private final byte[] script;
  private final AtomicInteger asked = new AtomicInteger();

  /** Sends {@code script}. */
  public FakeDriver(String script) throws IOException {
    this.script = script.getBytes(StandardCharsets.UTF_8);
    server = new ServerSocket(0, 0, InetAddress.getLoopbackAddress());
    Thread.ofVirtual().start(this::serve);
  }

  /** Where it is. */
  public ControlHost host() {
    return new ControlHost("127.0.0.1", server.getLocalPort());
  }

  /** How often it has sent its script. */
  public int asked() {
    return asked.get();
  }

  private void serve() {
    while (!server.isClosed()) {
      try (Socket client = server.accept()) {
        int each = client.getInputStream().read();
        while (each >= 0) {
          if (each == '\n') {
            asked.incrementAndGet();
            client.getOutputStream().write(script);
          }
          each = client.getInputStream().read();
        }
      } catch (IOException e) {
        // closed by either side; the next one is served
      }
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}
