package org.pendant.desktop.scene.gl;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Pick;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.Ray;
import org.pendant.desktop.scene.SceneModel;

/**
 * Offscreen scene: draws models into images, without a window. All of OpenGL happens on one thread
 * of its own; the methods may be called from any.
 */
public final class OffscreenScene implements AutoCloseable {
  /** Largest width and height of an image, pixels; every OpenGL 3.3 has room for it. */
  public static final int MAX_PX = 4096;

  private final ExecutorService thread;
  private final GlContext context;
  private final SceneRenderer renderer;

  private OffscreenScene(ExecutorService thread, GlContext context, SceneRenderer renderer) {
    this.thread = thread;
    this.context = context;
    this.renderer = renderer;
  }

  /**
   * Starts OpenGL.
   *
   * @throws SceneUnavailable if this machine cannot draw; everything else works without
   */
  public static OffscreenScene open() throws SceneUnavailable {
    return open(EglContext::open);
  }

  static OffscreenScene open(GlContext.Opener opener) throws SceneUnavailable {
    ExecutorService thread =
        Executors.newSingleThreadExecutor(Thread.ofPlatform().name("scene").daemon().factory());
    try {
      return CompletableFuture.supplyAsync(() -> start(thread, opener), thread).join();
    } catch (CompletionException e) {
      thread.shutdown();
      if (e.getCause() instanceof SceneUnavailable why) {
        throw why;
      }
      throw e;
    }
  }

  private static OffscreenScene start(ExecutorService thread, GlContext.Opener opener) {
    try {
      GlContext context = opener.open();
      return new OffscreenScene(thread, context, new SceneRenderer());
    } catch (SceneUnavailable e) {
      throw new CompletionException(e);
    }
  }

  /** The graphics that draw, in the words of their driver. */
  public String graphics() {
    return CompletableFuture.supplyAsync(context::renderer, thread).join();
  }

  /**
   * Draws a picture in the best quality and waits for it; width and height are 1 to {@link #MAX_PX}
   * pixels.
   */
  public BufferedImage render(SceneModel model, Camera camera, int width, int height) {
    return draw(model, camera, Quality.FULL, image(width, height)).join();
  }

  /**
   * Draws into an image; do not touch it until then.
   *
   * @param into of {@link #image}
   */
  public CompletableFuture<BufferedImage> draw(
      SceneModel model, Camera camera, Quality quality, BufferedImage into) {
    int[] pixels = ((DataBufferInt) into.getRaster().getDataBuffer()).getData();
    return CompletableFuture.supplyAsync(
        () -> {
          renderer.render(model, camera, quality, into.getWidth(), into.getHeight(), pixels);
          return into;
        },
        thread);
  }

  /** What a ray meets in the model; see {@link Pick}. */
  public CompletableFuture<Optional<Picked>> pick(Ray ray, SceneModel model) {
    return CompletableFuture.supplyAsync(
        () -> Pick.at(ray, model, renderer.armMeshes(model)), thread);
  }

  /**
   * An image that can be drawn into.
   *
   * @throws IllegalArgumentException if a side is not 1 to {@link #MAX_PX} pixels
   */
  public static BufferedImage image(int width, int height) {
    if (width < 1 || height < 1 || width > MAX_PX || height > MAX_PX) {
      throw new IllegalArgumentException(
          "image is " + width + "x" + height + ", each side must be 1 to " + MAX_PX);
    }
    return new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
  }

  /** Ends OpenGL once all pictures that were asked for are drawn. */
  @Override
  public void close() {
    thread.execute(
        () -> {
          renderer.close();
          context.close();
        });
    thread.close();
  }
}
