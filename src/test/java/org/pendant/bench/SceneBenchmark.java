package org.pendant.bench;

import java.awt.image.BufferedImage;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.pendant.command.service.StandardView;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.Quality;
import org.pendant.desktop.scene.gl.SceneUnavailable;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/**
 * A picture of 600x700 of a UR5e that moves, drawn and read back. Without a GPU, {@code
 * LP_NUM_THREADS=1} says what it takes beside a busy core.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Thread)
public class SceneBenchmark {
  private static final int WIDTH = 600;
  private static final int HEIGHT = 700;

  /** How well it is drawn. */
  @Param public Quality quality;

  private final ArmDescription arm = ArmLibrary.load("ur5e");
  private final BufferedImage image = OffscreenScene.image(WIDTH, HEIGHT);
  private OffscreenScene scene;
  private Camera camera;
  private double timeS;

  @Setup
  public void open() throws SceneUnavailable {
    scene = OffscreenScene.open();
    camera = Camera.of(StandardView.ISO, SceneBounds.of(model()), (double) WIDTH / HEIGHT);
  }

  private SceneModel model() {
    timeS += 0.03;
    double sway = Math.sin(timeS);
    return SceneModel.of(
        arm, Joints.of(0.3 + 0.5 * sway, -1.4 + 0.2 * sway, 1.6, -1.7, -1.57, timeS % 6));
  }

  @Benchmark
  public BufferedImage picture() {
    return scene.draw(model(), camera, quality, image).join();
  }

  @TearDown
  public void close() {
    scene.close();
  }
}
