package org.pendant.desktop.scene.view;

import static org.pendant.desktop.scene.view.PictureTexts.text;

import java.awt.Cursor;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleConsumer;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.function.LongConsumer;
import javax.swing.SwingUtilities;
import org.pendant.desktop.unit.PoseForm;

/**
 * Mark mouse: the pointer on places and ways of the program: shows what is known of them, and a
 * click chooses the node that goes there, or the moment and the line at which the tool was there.
 */
final class MarkMouse extends MouseAdapter {
  private final SceneView view;
  private PoseForm form = PoseForm.STANDARD;
  private IntFunction<String> places = line -> text("line", line);
  private LongConsumer chosen = node -> {};
  private IntConsumer lineChosen = line -> {};
  private DoubleConsumer momentChosen = timeS -> {};
  private List<LabelPlaces.Placed> labels = List.of();
  private Optional<Point> pointer = Optional.empty();
  private Optional<MarkTarget> target = Optional.empty();

  /** Nobody listens yet. */
  MarkMouse(SceneView view) {
    this.view = view;
  }

  /** In which people read poses and speeds. */
  PoseForm form() {
    return form;
  }

  void setForm(PoseForm next) {
    form = next;
  }

  /** What lines of the program are called. */
  void setPlaces(IntFunction<String> names) {
    places = names;
  }

  void setListener(LongConsumer listener) {
    chosen = listener;
  }

  void setLineListener(IntConsumer listener) {
    lineChosen = listener;
  }

  void setMomentListener(DoubleConsumer listener) {
    momentChosen = listener;
  }

  /** Where names stand since the last painting. */
  void setLabels(List<LabelPlaces.Placed> placed) {
    labels = placed;
  }

  /** What the pointer is on. */
  Optional<MarkTarget> target() {
    return target;
  }

  /** What is seen; empty while nothing is. */
  Optional<MarkFinder> finder() {
    return view.drawn()
        .map(
            shown ->
                new MarkFinder(shown, view.getWidth(), view.getHeight(), labels, form, places));
  }

  /** Chooses the node of the next stop of the program, or the one before. */
  void step(int by) {
    view.drawn()
        .flatMap(shown -> shown.model().waypointMarkers().stepped(by))
        .ifPresent(stop -> chosen.accept(stop.node()));
  }

  private void look(Optional<Point> pointer) {
    Optional<MarkTarget> now = pointer.flatMap(at -> finder().flatMap(finder -> finder.at(at)));
    if (!now.equals(target)) {
      boolean leads = now.filter(MarkMouse::leads).isPresent();
      target = now;
      view.setCursor(
          Cursor.getPredefinedCursor(leads ? Cursor.HAND_CURSOR : Cursor.DEFAULT_CURSOR));
      view.repaint();
    }
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    if (!view.pointerTaken()) {
      pointer = Optional.of(event.getPoint());
      look(pointer);
    }
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    if (target.isPresent() && !view.pointerTaken()) {
      leave();
    }
  }

  @Override
  public void mouseExited(MouseEvent event) {
    if (!view.pointerTaken()) {
      leave();
    }
  }

  @Override
  public void mouseClicked(MouseEvent event) {
    if (event.getClickCount() == 1 && SwingUtilities.isLeftMouseButton(event)) {
      finder()
          .flatMap(finder -> finder.at(event.getPoint()))
          .filter(MarkMouse::leads)
          .ifPresent(this::choose);
    }
  }

  /** Another picture is shown: what the pointer was on may be elsewhere, or gone. */
  void look() {
    if (target.isPresent() && !view.pointerTaken()) {
      look(pointer);
    }
  }

  /** The picture has another size: where the pointer is in it is known when it moves again. */
  void leave() {
    pointer = Optional.empty();
    look(pointer);
  }

  private static boolean leads(MarkTarget target) {
    return target.node() != 0 || !Double.isNaN(target.timeS());
  }

  private void choose(MarkTarget there) {
    if (there.node() != 0) {
      chosen.accept(there.node());
    } else {
      momentChosen.accept(there.timeS());
      if (there.line() != 0) {
        lineChosen.accept(there.line());
      }
    }
  }
}
