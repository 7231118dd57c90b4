package org.pendant.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.command.service.GraphicsUnavailable;
import org.pendant.command.service.Picture;
import org.pendant.command.service.PictureRenderer;
import org.pendant.command.service.StandardView;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileDraft;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ControllerState;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.report.FailureAttachment;
import org.pendant.testing.report.FailureAttachment.Kind;
import org.pendant.testing.run.TestObserver;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestRunner;

/**
 * Red tests of a suite, each run once more, exactly as it ran, to record it and to draw the arm as
 * it stood in the end.
 */
final class RedTests {
  /** Most tests that are recorded: what breaks everything is understood by the first ones. */
  private static final int MAX_RECORDED = 20;

  private static final int MAX_NAME = 80;
  private static final int WIDTH_PX = 800;
  private static final int HEIGHT_PX = 600;

  private final TestRunner runner;
  private final TestPlan plan;
  private final ControllerOptions options;
  private final DesktopServices services;

  RedTests(TestRunner runner, TestPlan plan, ControllerOptions options, DesktopServices services) {
    this.runner = runner;
    this.plan = plan;
    this.options = options;
    this.services = services;
  }

  /**
   * Records the red tests.
   *
   * @param folder is made
   * @param inside where in it, ending with {@code /}; empty for the folder itself
   * @param pictures whether the arm is drawn as well, where this computer can
   * @return the files of each test
   * @throws UsageException if they cannot be written
   */
  Map<TestId, List<FailureAttachment>> record(
      SuiteResult result, Path folder, String inside, boolean pictures) throws UsageException {
    Map<TestId, List<FailureAttachment>> files = new LinkedHashMap<>();
    List<TestResult> red =
        result.results().stream().filter(each -> each.status().red()).limit(MAX_RECORDED).toList();
    try {
      for (int i = 0; i < red.size(); i++) {
        TestId id = red.get(i).id();
        String name = inside + (i + 1) + "-" + name(id);
        files.put(id, record(id, folder, name, pictures));
      }
    } catch (IOException e) {
      throw new UsageException(folder + ": cannot be written, " + FileTrouble.reason(e));
    } catch (UncheckedIOException e) {
      throw new UsageException(folder + ": cannot be written, " + FileTrouble.reason(e.getCause()));
    }
    return files;
  }

  /** A name that every file system takes, and that cannot lead elsewhere. */
  private static String name(TestId id) {
    String file = id.file().substring(id.file().lastIndexOf('/') + 1).replaceAll("\\.script$", "");
    String name = (file + "." + id.name()).replaceAll("[^A-Za-z0-9._-]+", "_");
    return name.substring(0, Math.min(MAX_NAME, name.length()));
  }

  private List<FailureAttachment> record(TestId id, Path folder, String name, boolean pictures)
      throws IOException {
    List<FailureAttachment> files = new ArrayList<>();
    Path recording = folder.resolve(name + ".rec");
    Files.createDirectories(recording.toAbsolutePath().getParent());
    Optional<PictureRenderer> renderer = pictures ? renderer() : Optional.empty();
    try (FileDraft draft = FileDraft.replacing(recording)) {
      Taking taking = new Taking(draft, renderer);
      runner.repeat(plan, id, taking);
      taking.recorder.close();
      draft.commit();
      files.add(new FailureAttachment(name + ".rec", "Recording, for pendant open", Kind.LINK));
      if (renderer.isPresent() && taking.moved) {
        Picture picture = picture(taking.last);
        AtomicFile.write(folder.resolve(name + ".png"), out -> renderer.get().write(picture, out));
        files.addFirst(
            new FailureAttachment(name + ".png", "The arm at the end of the test", Kind.IMAGE));
      }
    } finally {
      renderer.ifPresent(PictureRenderer::close);
    }
    return files;
  }

  private Optional<PictureRenderer> renderer() {
    Optional<PictureRenderer.Factory> factory = services.renderers().get();
    try {
      return factory.isPresent() ? Optional.of(factory.get().start()) : Optional.empty();
    } catch (GraphicsUnavailable _) {
      // the report says everything else without a picture
      return Optional.empty();
    }
  }

  private Picture picture(ControllerState state) {
    return new Picture(
        options.robotId(),
        state.arm(),
        options.scene(),
        Optional.empty(),
        state.safety(),
        StandardView.ISO,
        false,
        WIDTH_PX,
        HEIGHT_PX);
  }

  /** Records a test, and keeps what is needed for a picture of it. */
  private static final class Taking implements TestObserver {
    private final TestRecorder recorder;
    private final Optional<PictureRenderer> renderer;
    private ControllerState last;

    /** There is something to see. */
    private boolean moved;

    Taking(FileDraft draft, Optional<PictureRenderer> renderer) {
      recorder = new TestRecorder(draft.out());
      this.renderer = renderer;
    }

    @Override
    public void begins(Drive of) {
      last = of.state();
      recorder.begins(of);
    }

    @Override
    public void sees(ControllerState state) {
      last = state;
      moved |= state.arm().moving();
      renderer.ifPresent(each -> each.trace(state.arm(), state.timeS()));
      recorder.sees(state);
    }
  }
}
