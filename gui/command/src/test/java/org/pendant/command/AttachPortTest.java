package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.Pace;
import org.pendant.controller.SteerableClock;

final class AttachPortTest {
  private static final String ATTACH =
      "{\"seq\":1,\"type\":\"request\",\"command\":\"attach\",\"arguments\":{}}";

  private final Controller controller = new Controller(ControllerOptions.headless());
  private final FrameLoop loop = FrameLoop.start(controller, new SteerableClock(Pace.REAL_TIME));
  private final Console console =
      new Console(new ByteArrayOutputStream(), new ByteArrayOutputStream());
  private final int port = freePort();

  @AfterEach
  void end() {
    loop.close();
  }

  static int freePort() {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** An editor that asks to attach. */
  private Socket editor() throws IOException {
    Socket editor = new Socket(InetAddress.getLoopbackAddress(), port);
    editor
        .getOutputStream()
        .write(
            ("Content-Length: " + ATTACH.length() + "\r\n\r\n" + ATTACH)
                .getBytes(StandardCharsets.US_ASCII));
    return editor;
  }

  /** The next message with a word in it. */
  private static String message(Socket editor, String word) throws IOException {
    String next = message(editor);
    while (!next.contains(word)) {
      next = message(editor);
    }
    return next;
  }

  /** The next message. */
  private static String message(Socket editor) throws IOException {
    DataInputStream in = new DataInputStream(editor.getInputStream());
    StringBuilder head = new StringBuilder();
    while (head.indexOf("\r\n\r\n") < 0) {
      head.append((char) in.readByte());
    }
    int length = Integer.parseInt(head.toString().replaceAll("\\D", ""));
    return new String(in.readNBytes(length), StandardCharsets.UTF_8);
  }

  @Test
  void anEditorAttachesToTheRobotThatIsShownUntilItIsHidden() throws Exception {
    try (AttachPort attachPort = new AttachPort("open", port, console)) {
      attachPort.show(controller, controller::programSource);
      try (Socket editor = editor()) {
        assertTrue(message(editor, "\"response\"").contains("\"success\":true"));
        assertTrue(message(editor, "\"initialized\"").contains("\"event\""));
        attachPort.hide();
        assertThrows(IOException.class, () -> message(editor, "no message has this"));
      }
      attachPort.show(controller, () -> Optional.empty());
      try (Socket again = editor()) {
        assertTrue(message(again, "\"response\"").contains("\"success\":true"));
      }
    }
  }

  @Test
  void beforeARobotIsShownThereIsNothingToAttachTo() throws Exception {
    try (AttachPort attachPort = new AttachPort("open", port, console)) {
      attachPort.hide();
      try (Socket editor = editor()) {
        assertTrue(message(editor, "\"response\"").contains("there is no robot to attach to"));
      }
    }
  }
}
