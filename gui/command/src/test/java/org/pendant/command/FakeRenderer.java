package org.pendant.command;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.pendant.command.service.Picture;
import org.pendant.command.service.PictureRenderer;
import org.pendant.controller.state.ArmState;

/** Renderer that remembers what it was asked for. */
final class FakeRenderer implements PictureRenderer {
  private Optional<Picture> picture = Optional.empty();
  private double lastS;
  private boolean closed;

  @Override
  public void trace(ArmState arm, double timeS) {
    lastS = timeS;
  }

  @Override
  public void write(Picture asked, OutputStream out) throws IOException {
    picture = Optional.of(asked);
    out.write("drawn".getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public void close() {
    closed = true;
  }

  /** The last picture that was asked for. */
  Picture picture() {
    return picture.orElseThrow();
  }

  /** Robot time of the last point of the trace, s. */
  double lastS() {
    return lastS;
  }

  boolean closed() {
    return closed;
  }
}
