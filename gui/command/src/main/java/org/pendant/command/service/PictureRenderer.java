package org.pendant.command.service;

import java.io.IOException;
import java.io.OutputStream;
import org.pendant.controller.state.ArmState;

/** Picture renderer: draws the arm for {@code pendant render}. Belongs to one thread. */
public interface PictureRenderer extends AutoCloseable {

  /** Service that starts renderers. */
  interface Factory {

    /**
     * Starts the graphics.
     *
     * @throws GraphicsUnavailable if this machine cannot draw; everything else works without
     */
    PictureRenderer start() throws GraphicsUnavailable;
  }

  /** Adds where the tool centre point is at a robot time, s, to its trace in the picture. */
  void trace(ArmState arm, double timeS);

  /**
   * Draws a picture and writes it as PNG.
   *
   * @throws IOException if it cannot be written
   */
  void write(Picture picture, OutputStream out) throws IOException;

  /** Ends the graphics. */
  @Override
  void close();
}
