package org.pendant.protocols.dashboard;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import org.pendant.protocols.script.RunningBox;

/** A client of a server that speaks in lines. */
public final class DashboardTalk implements AutoCloseable {
  private final Socket socket;
  private final BufferedReader lines;
  private final String greeting;

  /** Connects to a port of this computer. */
  public DashboardTalk(int port) throws IOException {
    socket = new Socket(InetAddress.getLoopbackAddress(), port);
    socket.setSoTimeout(RunningBox.GIVE_UP_MS);
    lines =
        new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.ISO_8859_1));
    greeting = line();
  }

  String greeting() {
    return greeting;
  }

  void send(String text) throws IOException {
    socket.getOutputStream().write(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** The next line; the text <i>end</i> at the end. */
  String line() throws IOException {
    String line = lines.readLine();
    return line == null ? "end" : line;
  }

  /** Sends a line; answers the next one that comes. */
  public String ask(String line) throws IOException {
    send(line + "\n");
    return line();
  }

  /** Asks again and again until the answer comes that must come. */
  void askUntil(String line, String answer) throws IOException {
    long giveUpNs = System.nanoTime() + RunningBox.GIVE_UP_MS * 1_000_000L;
    String last = ask(line);
    while (!last.equals(answer)) {
      if (System.nanoTime() > giveUpNs) {
        throw new AssertionError(line + ": expected " + answer + ", the last was " + last);
      }
      last = ask(line);
    }
  }

  /** Whether the server has ended the connection. */
  boolean ended() throws IOException {
    try {
      return lines.readLine() == null;
    } catch (SocketException e) {
      // reset, as there was something left to read for the server
      return true;
    }
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
