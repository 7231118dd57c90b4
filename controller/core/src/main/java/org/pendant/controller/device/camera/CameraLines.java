package org.pendant.controller.device.camera;

import static org.pendant.controller.device.camera.CameraTexts.text;

import java.util.List;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.models.pose.Pose;

/**
 * Camera lines: what a camera is asked by lines of text. {@code GET} is answered by how many parts
 * there are and the pose of the first, {@code GET 1} by that of the second; a name before the
 * number asks for the parts of this name. Seven numbers in parentheses, as {@code
 * socket_read_ascii_float(7)} takes them; zeros where there is no such part.
 */
public final class CameraLines implements DeviceTalk {
  private static final int MAX_LINE = 1024;
  private static final Pattern REQUEST = Pattern.compile("GET(?: +(.*?))??(?: +(\\d{1,9}))?");
  private static final String NO = "?\n";

  private final PartCamera camera;
  private final String name;
  private final Consumer<String> complain;
  private final StringBuilder line = new StringBuilder();

  /**
   * A connection that was just opened.
   *
   * @param name that of the camera
   * @param complain is told what is no request
   */
  public CameraLines(String name, PartCamera camera, Consumer<String> complain) {
    this.name = name;
    this.camera = camera;
    this.complain = complain;
  }

  @Override
  public String hear(String bytes) {
    if (bytes.isEmpty() && line.isEmpty()) {
      return "";
    }
    StringBuilder answers = new StringBuilder();
    line.append(bytes);
    for (int end = line.indexOf("\n"); end >= 0; end = line.indexOf("\n")) {
      answers.append(answer(line.substring(0, end).strip()));
      line.delete(0, end + 1);
    }
    // a request without its newline has ended when nothing has followed it for a frame
    if (bytes.isEmpty() || line.length() > MAX_LINE) {
      answers.append(answer(line.toString().strip()));
      line.setLength(0);
    }
    return answers.toString();
  }

  private String answer(String text) {
    if (text.isEmpty()) {
      return "";
    }
    Matcher request = REQUEST.matcher(text);
    if (!request.matches()) {
      complain.accept(text("badRequest", name, text));
      return NO;
    }
    List<SeenPart> parts = camera.look(request.group(1) == null ? "" : request.group(1));
    int index = request.group(2) == null ? 0 : Integer.parseInt(request.group(2));
    Pose pose = index < parts.size() ? parts.get(index).pose() : Pose.ZERO;
    StringBuilder answer = new StringBuilder("(").append(parts.size());
    for (double each : pose.toArray()) {
      answer.append(", ").append(each);
    }
    return answer.append(")\n").toString();
  }
}
