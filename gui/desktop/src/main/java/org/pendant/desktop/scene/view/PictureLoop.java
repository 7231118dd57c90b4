package org.pendant.desktop.scene.view;

import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.Quality;

/**
 * Picture loop: draws the newest picture that was asked for, one at a time, elsewhere; whatever was
 * asked for in between is dropped. While pictures follow each other they are drawn as well as there
 * is time for ({@link AdaptiveQuality}); {@link #settle} has the last one drawn again in full.
 *
 * <p>Belongs to the thread of its executor, the dispatch thread.
 */
final class PictureLoop {
  /** Half of what a picture may take at 60 in a second, ns. */
  private static final long FAST_NS = 8_000_000;

  private final Painter painter;
  private final Executor dispatcher;
  private final LongSupplier nowNs;
  private final Consumer<BufferedImage> show;
  private Optional<PictureRequest> wanted = Optional.empty();
  private Optional<PictureRequest> drawn = Optional.empty();
  private Optional<BufferedImage> shown = Optional.empty();
  private Optional<BufferedImage> spare = Optional.empty();
  private long lastNs = Long.MAX_VALUE;
  private final AdaptiveQuality pace = new AdaptiveQuality();
  private boolean busy;
  private boolean ended;
  private boolean settled;
  private boolean drawnInFull = true;

  /** Draws elsewhere. */
  @FunctionalInterface
  interface Painter {
    /** Draws a picture into an image of its size. */
    CompletableFuture<BufferedImage> draw(PictureRequest request, BufferedImage into);
  }

  /**
   * @param dispatcher runs what follows a picture
   * @param nowNs a clock for how long drawing takes, ns
   * @param show takes each new picture; it may be kept until the next one comes
   */
  PictureLoop(
      Painter painter, Executor dispatcher, LongSupplier nowNs, Consumer<BufferedImage> show) {
    this.painter = painter;
    this.dispatcher = dispatcher;
    this.nowNs = nowNs;
    this.show = show;
  }

  /** Wants this picture from now on; answers whether it wanted another one before. */
  boolean want(PictureRequest request) {
    if (wanted.equals(Optional.of(request))) {
      return false;
    }
    boolean following = wanted.isPresent() && sameSize(wanted.get(), request);
    if (!following) {
      pace.forget();
    }
    wanted = Optional.of(request);
    settled = !following;
    if (!busy) {
      draw(request);
    }
    return true;
  }

  /**
   * Whether there is time for pictures between those of every refresh of the window: the last one
   * was drawn so fast that a GPU must be at work. Without one it would take the time of others.
   */
  boolean hasTime() {
    return !busy && lastNs < FAST_NS;
  }

  /** Nothing has changed for a while: what was drawn quickly deserves to be drawn in full. */
  void settle() {
    settled = true;
    if (!busy && !drawnInFull) {
      draw(wanted.orElseThrow());
    }
  }

  private static boolean sameSize(PictureRequest a, PictureRequest b) {
    return a.widthPx() == b.widthPx() && a.heightPx() == b.heightPx();
  }

  private void draw(PictureRequest request) {
    Quality quality = settled ? Quality.FULL : pace.quality();
    long startNs = nowNs.getAsLong();
    CompletableFuture<BufferedImage> begun = painter.draw(request.as(quality), image(request));
    // Not before: a drawing that could not begin has no end either.
    busy = true;
    var _ =
        begun.whenComplete(
            (image, failure) ->
                dispatcher.execute(
                    () -> {
                      lastNs = nowNs.getAsLong() - startNs;
                      pace.took(quality, (double) lastNs);
                      drawnInFull = quality == Quality.FULL;
                      finished(request, image, failure);
                    }));
  }

  /** Asks for no picture any more; one that is being drawn is not shown. */
  void end() {
    ended = true;
  }

  private void finished(PictureRequest request, BufferedImage image, Throwable failure) {
    busy = false;
    if (ended) {
      return;
    }
    if (failure != null) {
      throw new IllegalStateException("the scene could not be drawn", failure);
    }
    drawn = Optional.of(request);
    spare = shown;
    shown = Optional.of(image);
    show.accept(image);
    PictureRequest newest = wanted.orElseThrow();
    if (!request.equals(newest) || (settled && !drawnInFull)) {
      draw(newest);
    }
  }

  /** What is on the screen. */
  Optional<PictureRequest> drawn() {
    return drawn;
  }

  /** The image before the shown one, if it has the size; it is not shown any more. */
  private BufferedImage image(PictureRequest request) {
    return spare
        .filter(
            image ->
                image.getWidth() == request.widthPx() && image.getHeight() == request.heightPx())
        .orElseGet(() -> OffscreenScene.image(request.widthPx(), request.heightPx()));
  }
}
