package org.pendant.protocols.externalcontrol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.pendant.controller.installation.ControlHost;

/** A driver on this computer: answers each line as it is told, and leaves the connection open. */
public final class FakeDriver implements AutoCloseable {
  private final ServerSocket server;
  private final Answer answer;
  private final List<String> questions = new CopyOnWriteArrayList<>();

  /** What it sends. */
  @FunctionalInterface
  public interface Answer {
    /** Sends it. */
    void to(OutputStream client) throws IOException;
  }

  /** Sends {@code text} to everybody who asks. */
  public FakeDriver(String text) throws IOException {
    this(client -> client.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /** Sends {@code answer} to everybody who asks. */
  public FakeDriver(Answer answer) throws IOException {
    this.answer = answer;
    server = new ServerSocket(0, 0, InetAddress.getLoopbackAddress());
    Thread.ofVirtual().start(this::accept);
  }

  /** Where it is. */
  public ControlHost host() {
    return new ControlHost("127.0.0.1", server.getLocalPort());
  }

  /** The lines that it was sent. */
  public List<String> questions() {
    return questions;
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        Socket client = server.accept();
        Thread.ofVirtual().start(() -> serve(client));
      } catch (IOException e) {
        return;
      }
    }
  }

  private void serve(Socket client) {
    try (client;
        BufferedReader in =
            new BufferedReader(
                new InputStreamReader(client.getInputStream(), StandardCharsets.US_ASCII))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        questions.add(line);
        answer.to(client.getOutputStream());
      }
    } catch (IOException e) {
      // the client has gone
      return;
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
  }
}
