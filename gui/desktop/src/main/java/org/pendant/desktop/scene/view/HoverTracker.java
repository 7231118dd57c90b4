package org.pendant.desktop.scene.view;

import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.BiFunction;
import org.pendant.desktop.scene.Picked;

/**
 * Hover tracker: knows what the pointer is on: asks once at a time, and again when the pointer or
 * the picture has moved meanwhile. Belongs to the dispatch thread.
 */
final class HoverTracker extends MouseAdapter {
  private final BiFunction<Integer, Integer, CompletableFuture<Optional<Picked>>> pick;
  private final Executor dispatcher;
  private final Runnable changed;
  private Optional<Point> pointer = Optional.empty();
  private Optional<String> name = Optional.empty();
  private boolean asking;
  private boolean again;

  /**
   * @param pick tells what is at a point, later
   * @param dispatcher runs what follows
   * @param changed runs when there is another name to show
   */
  HoverTracker(
      BiFunction<Integer, Integer, CompletableFuture<Optional<Picked>>> pick,
      Executor dispatcher,
      Runnable changed) {
    this.pick = pick;
    this.dispatcher = dispatcher;
    this.changed = changed;
  }

  /** Where the pointer rests on the picture; empty outside, and while a button is held. */
  Optional<Point> pointer() {
    return pointer;
  }

  /** What it is on. */
  Optional<String> name() {
    return pointer.flatMap(inside -> name);
  }

  /** The picture has changed. */
  void look() {
    if (pointer.isEmpty()) {
      return;
    }
    if (asking) {
      again = true;
      return;
    }
    asking = true;
    again = false;
    var _ =
        pick.apply(pointer.get().x, pointer.get().y)
            .whenComplete((found, failure) -> dispatcher.execute(() -> answer(found, failure)));
  }

  private void answer(Optional<Picked> found, Throwable failure) {
    asking = false;
    if (failure != null) {
      throw new IllegalStateException("what is under the pointer could not be found", failure);
    }
    tell(found.map(PickedName::of));
    if (again) {
      look();
    }
  }

  private void tell(Optional<String> found) {
    if (!found.equals(name)) {
      name = found;
      changed.run();
    }
  }

  @Override
  public void mouseMoved(MouseEvent event) {
    pointer = Optional.of(event.getPoint());
    if (name.isPresent()) {
      changed.run();
    }
    look();
  }

  @Override
  public void mousePressed(MouseEvent event) {
    leave();
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    leave();
  }

  @Override
  public void mouseExited(MouseEvent event) {
    leave();
  }

  /** The pointer is elsewhere, or where it is in the picture is not known. */
  void leave() {
    pointer = Optional.empty();
    tell(Optional.empty());
  }
}
