package org.pendant.desktop.scene.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Picked;
import org.pendant.kit.theme.Palette;

/**
 * Arm drag: the mouse that pulls the arm at the point where it was grabbed. What is under the
 * pointer is known a moment after the press; until then, and while something is held, the view does
 * not turn.
 */
final class ArmDrag extends MouseAdapter {
  private static final double DOT_EM = 0.45;

  private final SceneView view;
  private ArmHand hand = ArmHand.NONE;
  private Optional<HeldPoint> held = Optional.empty();
  private Optional<Vector3> place = Optional.empty();
  private boolean asking;
  private int x;
  private int y;

  /** Counts the presses, so that an answer to an earlier one is dropped. */
  private int press;

  ArmDrag(SceneView view) {
    this.view = view;
  }

  void setHand(ArmHand hand) {
    release();
    this.hand = hand;
  }

  /** Whether the pointer holds the arm, or will perhaps in a moment. */
  boolean takesPointer() {
    return asking || held.isPresent();
  }

  @Override
  public void mousePressed(MouseEvent event) {
    release();
    Optional<PictureRequest> shown = view.drawn();
    boolean key = event.isControlDown() || event.isMetaDown();
    if (!SwingUtilities.isLeftMouseButton(event)
        || event.isShiftDown()
        || shown.isEmpty()
        || !hand.grabs(key)) {
      return;
    }
    follow(event);
    asking = true;
    int asked = ++press;
    var _ =
        view.pick(x, y)
            .whenComplete(
                (found, failure) ->
                    EventQueue.invokeLater(
                        () -> {
                          if (failure != null) {
                            throw new IllegalStateException(
                                "what is under the pointer could not be found", failure);
                          }
                          answer(asked, found, shown.get());
                        }));
  }

  private void answer(int asked, Optional<Picked> found, PictureRequest shown) {
    if (!asking || asked != press) {
      return;
    }
    asking = false;
    held = found.flatMap(picked -> HeldPoint.of(picked, shown.model(), shown.camera()));
    if (held.isPresent()) {
      HeldPoint point = held.get();
      place = Optional.of(placeNow().orElse(point.grabbedInBaseM()));
      hand.begin(point.link(), point.inLinkM(), place.get());
      view.setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
      view.repaint();
    }
  }

  private Optional<Vector3> placeNow() {
    return held.flatMap(
        point ->
            view.camera()
                .flatMap(
                    camera ->
                        point.placeM(
                            camera.ray(x + 0.5, y + 0.5, view.getWidth(), view.getHeight()))));
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    follow(event);
    Optional<Vector3> next = placeNow();
    if (next.isPresent()) {
      place = next;
      hand.move(next.get());
      view.repaint();
    }
  }

  private void follow(MouseEvent event) {
    x = event.getX();
    y = event.getY();
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    release();
  }

  /** Lets go, if anything is held. */
  void release() {
    asking = false;
    if (held.isPresent()) {
      held = Optional.empty();
      place = Optional.empty();
      hand.end();
      view.setCursor(Cursor.getDefaultCursor());
      view.repaint();
    }
  }

  /** Draws the line along which the arm is pulled. */
  void paint(Graphics2D graphics, PictureRequest shown, int width, int height) {
    if (held.isEmpty() || place.isEmpty() || !hand.pulls()) {
      return;
    }
    Optional<Point2D> from = shown.camera().pixel(held.get().inBaseM(shown.model()), width, height);
    Optional<Point2D> to = shown.camera().pixel(place.get(), width, height);
    if (from.isEmpty() || to.isEmpty()) {
      return;
    }
    double dot = DOT_EM * graphics.getFont().getSize();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    // a rim makes the line stand out from whatever is behind it
    draw(graphics, from.get(), to.get(), dot, Palette.card(), dot);
    draw(graphics, from.get(), to.get(), dot, Palette.accent(), dot / 3);
  }

  private static void draw(
      Graphics2D graphics, Point2D from, Point2D to, double dot, Color color, double width) {
    graphics.setColor(color);
    graphics.setStroke(new BasicStroke((float) width));
    graphics.draw(new Line2D.Double(from, to));
    graphics.draw(circle(from, dot / 3));
    graphics.draw(circle(to, dot));
  }

  private static Ellipse2D circle(Point2D middle, double radius) {
    return new Ellipse2D.Double(
        middle.getX() - radius, middle.getY() - radius, 2 * radius, 2 * radius);
  }
}
