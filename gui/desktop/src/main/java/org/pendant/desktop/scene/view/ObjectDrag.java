package org.pendant.desktop.scene.view;

import java.awt.Cursor;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.swing.SwingUtilities;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.Ray;

/**
 * Object drag: the mouse that places an object or a device of the scene: along the floor, up and
 * down with Ctrl, without steps with Alt. What is under the pointer is known a moment after the
 * press; until then, and while something is held, the view does not turn.
 */
final class ObjectDrag extends MouseAdapter {
  private static final Vector3 NOWHERE = new Vector3(0, 0, 0);
  private static final Vector3 UP = new Vector3(0, 0, 1);

  private final SceneView view;
  private ObjectHand hand = ObjectHand.NONE;
  private Optional<Hold> held = Optional.empty();
  private boolean asking;

  /** Whether the pointer is on a handle of a device. */
  private boolean onHandle;

  /** Where the pointer is while it holds something. */
  private Optional<Point> pointer = Optional.empty();

  /** How near to a handle the pointer has to be, in the size of letters. */
  private static final double NEAR_EM = 0.8;

  /** Counts the presses, so that an answer to an earlier one is dropped. */
  private int press;

  /**
   * What the pointer holds.
   *
   * @param fromM where it was when it began to go this way, in the base frame, m
   * @param wayM how far it had gone before, m
   * @param upright whether it goes up and down
   * @param facing the direction of the view where it goes in the plane of the picture
   */
  private record Hold(Vector3 fromM, Vector3 wayM, boolean upright, Optional<Vector3> facing) {

    /** How far it goes to a place, m. */
    Vector3 wayM(Vector3 placeM) {
      if (facing.isPresent()) {
        return new Vector3(
            wayM.x() + placeM.x() - fromM.x(),
            wayM.y() + placeM.y() - fromM.y(),
            wayM.z() + placeM.z() - fromM.z());
      }
      return upright
          ? new Vector3(wayM.x(), wayM.y(), wayM.z() + placeM.z() - fromM.z())
          : new Vector3(
              wayM.x() + placeM.x() - fromM.x(), wayM.y() + placeM.y() - fromM.y(), wayM.z());
    }

    /** The plane in which it goes, seen along a ray. */
    DragPlane plane(Ray ray) {
      return new DragPlane(
          fromM,
          facing.isPresent()
              ? facing.get()
              : upright ? new Vector3(ray.direction().x(), ray.direction().y(), 0) : UP);
    }
  }

  ObjectDrag(SceneView view) {
    this.view = view;
  }

  void setHand(ObjectHand hand) {
    release();
    this.hand = hand;
  }

  /** Whether the pointer holds something, or will perhaps in a moment. */
  boolean takesPointer() {
    return asking || held.isPresent();
  }

  @Override
  public void mousePressed(MouseEvent event) {
    release();
    if (!SwingUtilities.isLeftMouseButton(event)
        || event.isShiftDown()
        || view.drawn().isEmpty()
        || !hand.grabs(upright(event))) {
      return;
    }
    Optional<DeviceHandles.Handle> handle = handleAt(event.getPoint());
    if (handle.isPresent()) {
      if (hand.begin(handle.get())) {
        hold(handle.get().placeM(), upright(event));
      }
      return;
    }
    asking = true;
    int asked = ++press;
    boolean upright = upright(event);
    var _ =
        view.pick(event.getX(), event.getY())
            .whenComplete(
                (found, failure) ->
                    EventQueue.invokeLater(
                        () -> {
                          if (failure != null) {
                            throw new IllegalStateException(
                                "what is under the pointer could not be found", failure);
                          }
                          answer(asked, found, upright);
                        }));
  }

  private void answer(int asked, Optional<Picked> found, boolean upright) {
    if (!asking || asked != press) {
      return;
    }
    asking = false;
    if (found.isPresent()
        && found.get() instanceof Picked.OnObject(String name, Vector3 pointM, _)
        && hand.begin(name, pointM)) {
      hold(pointM, upright);
    }
  }

  private void hold(Vector3 pointM, boolean upright) {
    held = Optional.of(new Hold(pointM, NOWHERE, upright, facing()));
    view.setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
  }

  /** The direction of the view, where what is held goes in the plane of the picture. */
  private Optional<Vector3> facing() {
    return view.camera()
        .filter(camera -> hand.freely())
        .map(
            camera ->
                camera
                    .ray(
                        view.getWidth() / 2.0,
                        view.getHeight() / 2.0,
                        view.getWidth(),
                        view.getHeight())
                    .direction());
  }

  /** Where devices can be held now, and where that is seen. */
  Map<DeviceHandles.Handle, Point2D> handles() {
    if (!hand.hasHandles() || view.drawn().isEmpty()) {
      return Map.of();
    }
    PictureRequest shown = view.drawn().get();
    Map<DeviceHandles.Handle, Point2D> seen = new LinkedHashMap<>();
    for (DeviceHandles.Handle each : DeviceHandles.of(shown.model().devices())) {
      shown
          .camera()
          .pixel(each.placeM(), view.getWidth(), view.getHeight())
          .ifPresent(at -> seen.put(each, at));
    }
    return seen;
  }

  /** The nearest handle that the pointer is on. */
  private Optional<DeviceHandles.Handle> handleAt(Point point) {
    double nearPx = NEAR_EM * view.getFont().getSize();
    return handles().entrySet().stream()
        .filter(each -> each.getValue().distance(point) <= nearPx)
        .min(Comparator.comparingDouble(each -> each.getValue().distance(point)))
        .map(Map.Entry::getKey);
  }

  /** What is said of what is held, and where the pointer is then. */
  Optional<String> words() {
    return held.isPresent() && !hand.words().isEmpty()
        ? Optional.of(hand.words())
        : Optional.empty();
  }

  /** Where the pointer is while it holds something; empty while it does not. */
  Optional<Point> pointer() {
    return held.isPresent() ? pointer : Optional.empty();
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    boolean on = handleAt(event.getPoint()).isPresent();
    if (on != onHandle) {
      onHandle = on;
      view.setCursor(Cursor.getPredefinedCursor(on ? Cursor.MOVE_CURSOR : Cursor.DEFAULT_CURSOR));
    }
  }

  private static boolean upright(MouseEvent event) {
    return event.isControlDown() || event.isMetaDown();
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    Optional<Ray> ray =
        view.camera()
            .map(
                camera ->
                    camera.ray(
                        event.getX() + 0.5, event.getY() + 0.5, view.getWidth(), view.getHeight()));
    if (held.isEmpty() || ray.isEmpty()) {
      return;
    }
    Hold now = held.get();
    Optional<Vector3> place = now.plane(ray.get()).meet(ray.get());
    if (place.isEmpty()) {
      return;
    }
    Vector3 wayM = now.wayM(place.get());
    if (now.facing().isEmpty() && now.upright() != upright(event)) {
      held = Optional.of(new Hold(place.get(), wayM, upright(event), now.facing()));
    }
    hand.move(wayM, event.isAltDown());
    pointer = Optional.of(event.getPoint());
    view.repaint();
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
      hand.end();
      view.setCursor(Cursor.getDefaultCursor());
    }
  }
}
