package org.pendant.desktop.scene.view;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import javax.swing.SwingUtilities;
import org.pendant.desktop.scene.Camera;

/**
 * Camera mouse: left turns, right, middle or shift moves, the wheel zooms towards the pointer, a
 * double click looks at the tool.
 */
final class CameraMouse extends MouseAdapter {
  private static final double RAD_PER_PIXEL = 0.008;
  private static final double STEP = 1.13;

  private final SceneView view;
  private int lastX;
  private int lastY;

  CameraMouse(SceneView view) {
    this.view = view;
  }

  @Override
  public void mousePressed(MouseEvent event) {
    view.requestFocusInWindow();
    lastX = event.getX();
    lastY = event.getY();
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    int right = event.getX() - lastX;
    int down = event.getY() - lastY;
    lastX = event.getX();
    lastY = event.getY();
    if (view.pointerTaken()) {
      return;
    }
    boolean turn = SwingUtilities.isLeftMouseButton(event) && !event.isShiftDown();
    view.change(
        camera ->
            turn
                ? camera.orbited(-RAD_PER_PIXEL * right, RAD_PER_PIXEL * down)
                : camera.panned(right, down, view.getHeight()));
  }

  @Override
  public void mouseWheelMoved(MouseWheelEvent event) {
    double factor = Math.pow(STEP, event.getPreciseWheelRotation());
    view.change(
        (Camera camera) ->
            camera.dolliedAt(
                factor, event.getX(), event.getY(), view.getWidth(), view.getHeight()));
  }

  @Override
  public void mouseClicked(MouseEvent event) {
    if (event.getClickCount() == 2 && SwingUtilities.isLeftMouseButton(event)) {
      view.zoomToTool();
    }
  }
}
