package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.pendant.command.GoldenRecordings.Difference;
import org.pendant.command.service.GoldenComparison;
import org.pendant.command.service.GraphicsUnavailable;
import org.pendant.command.service.Picture;
import org.pendant.command.service.PictureRenderer;
import org.pendant.command.service.StandardView;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Drive;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileDraft;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.compare.MalformedTrack;
import org.pendant.recording.compare.RunTrack;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.report.FailureAttachment;
import org.pendant.testing.report.FailureAttachment.Kind;
import org.pendant.testing.report.FailurePlot;
import org.pendant.testing.run.TestObserver;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestRunner;

/**
 * Red tests of a suite, each run once more, exactly as it ran, to record it and to draw the arm as
 * it stood in the end, or where it first differed from its golden recording.
 */
final class RedTests {
  /** Most tests that are recorded: what breaks everything is understood by the first ones. */
  private static final int MAX_RECORDED = 20;

  private static final int MAX_NAME = 80;
  private static final int WIDTH_PX = 800;
  private static final int HEIGHT_PX = 600;

  private final TestRunner runner;
  private final TestPlan plan;
  private final GoldenRecordings goldens;
  private final ControllerOptions options;
  private final DesktopServices services;
  private final Map<TestId, FailurePlot> plots = new HashMap<>();

  RedTests(
      TestRunner runner,
      TestPlan plan,
      GoldenRecordings goldens,
      ControllerOptions options,
      DesktopServices services) {
    this.runner = runner;
    this.plan = plan;
    this.goldens = goldens;
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
      throw new UsageException(text("cannotBeWritten", folder, FileTrouble.reason(e)));
    } catch (UncheckedIOException e) {
      throw new UsageException(text("cannotBeWritten", folder, FileTrouble.reason(e.getCause())));
    }
    return files;
  }

  /** What was around the failures of the tests that were recorded with pictures. */
  Map<TestId, FailurePlot> plots() {
    return plots;
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
      Optional<Difference> golden = goldens.difference(id);
      Taking taking =
          new Taking(draft, renderer, golden.map(Difference::frame).orElse(Long.MAX_VALUE));
      runner.repeat(plan, id, taking);
      taking.recorder.close();
      draft.commit();
      if (pictures) {
        plots.put(id, taking.plot(golden));
      }
      files.add(new FailureAttachment(name + ".rec", "Recording, for pendant open", Kind.LINK));
      if (renderer.isPresent() && taking.moved) {
        Optional<ArmState> before = golden.flatMap(each -> recorded(each, taking.last.arm()));
        if (before.isPresent()) {
          files.addFirst(
              draw(
                  picture(before.get(), taking.last.safety()),
                  folder,
                  name + "-golden.png",
                  "The arm in the golden recording then; the line is the way of this run",
                  renderer.get()));
        }
        String title =
            golden
                .map(_ -> atDifference(taking.last.timeS()))
                .orElse("The arm at the end of the test");
        Picture picture = picture(taking.last.arm(), taking.last.safety());
        files.addFirst(draw(picture, folder, name + ".png", title, renderer.get()));
      }
    } finally {
      renderer.ifPresent(PictureRenderer::close);
    }
    return files;
  }

  private static String atDifference(double timeS) {
    return String.format(
        Locale.ROOT, "The arm at the first difference from the golden recording, %.3f s", timeS);
  }

  private FailureAttachment draw(
      Picture picture, Path folder, String name, String title, PictureRenderer renderer)
      throws IOException {
    AtomicFile.write(folder.resolve(name), out -> renderer.write(picture, out));
    return new FailureAttachment(name, title, Kind.IMAGE);
  }

  /** The arm as a golden recording has it where a test differs from it. */
  private static Optional<ArmState> recorded(Difference golden, ArmState arm) {
    try {
      RunTrack track = GoldenComparison.read(golden.recording(), false);
      return Optional.of(arm.withActualPosition(track.target(golden.frame())));
    } catch (IOException | UncheckedIOException | MalformedTrack _) {
      // it is gone since the test was compared with it
      return Optional.empty();
    }
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

  private Picture picture(ArmState arm, SafetyStatus safety) {
    return new Picture(
        options.robotId(),
        arm,
        options.scene(),
        List.of(),
        List.of(),
        Optional.empty(),
        safety,
        StandardView.ISO,
        false,
        WIDTH_PX,
        HEIGHT_PX);
  }

  /** Records a test, and keeps what is needed for a picture of it. */
  private static final class Taking implements TestObserver {
    private final TestRecorder recorder;
    private final Optional<PictureRenderer> renderer;
    private final long until;
    private final Deque<FailurePlot.Frame> frames = new ArrayDeque<>();
    private ControllerState last;

    /** There is something to see. */
    private boolean moved;

    /** Draws the arm as it stands in frame {@code until}, or in the last one before it. */
    Taking(FileDraft draft, Optional<PictureRenderer> renderer, long until) {
      recorder = new TestRecorder(draft.out());
      this.renderer = renderer;
      this.until = until;
    }

    /** What was around the moment of the failure. */
    private FailurePlot plot(Optional<Difference> golden) {
      double momentS = golden.map(each -> each.frame() * FrameTime.FRAME_S).orElse(last.timeS());
      return new FailurePlot(momentS, List.copyOf(frames));
    }

    @Override
    public void begins(Drive of) {
      last = of.state();
      frames.add(FailurePlot.Frame.of(last));
      recorder.begins(of);
    }

    @Override
    public void sees(ControllerState state) {
      moved |= state.arm().moving();
      if (state.frame() <= until) {
        last = state;
        renderer.ifPresent(each -> each.trace(state.arm(), state.timeS()));
      }
      if (state.timeS() <= last.timeS() + FailurePlot.AFTER_S) {
        frames.add(FailurePlot.Frame.of(state));
        while (frames.getFirst().timeS() < last.timeS() - FailurePlot.BEFORE_S) {
          frames.removeFirst();
        }
      }
      recorder.sees(state);
    }
  }
}
