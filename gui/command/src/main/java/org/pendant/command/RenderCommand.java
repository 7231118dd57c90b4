package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.command.service.GraphicsUnavailable;
import org.pendant.command.service.Picture;
import org.pendant.command.service.PictureRenderer;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.Controller;
import org.pendant.controller.world.MovedScene;
import org.pendant.language.source.Source;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** Command {@code pendant render FILE}: runs a program and draws the arm at one moment. */
final class RenderCommand implements Subcommand {
  private final DesktopServices services;

  RenderCommand(DesktopServices services) {
    this.services = services;
  }

  @Override
  public String name() {
    return "render";
  }

  @Override
  public String operands() {
    return "FILE";
  }

  @Override
  public List<Option> options() {
    return RenderOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().size() != 1) {
      throw new UsageException(text("oneFileExpected", arguments.operands().size()));
    }
    RunnableFile file = RunnableFile.read(arguments).getFirst();
    RenderOptions options = RenderOptions.of(arguments, file.installation(), file.robot());
    InstallationOption.tell(arguments, console);
    file.tell(console);
    try (ScriptConnectors scriptConnectors = new ScriptConnectors(options.run().hosts())) {
      Controller controller =
          new Controller(options.run().controller().withOutside(scriptConnectors.connectors()));
      return run(file.asked(options.run().drivers()), controller, options, console);
    } catch (NoScript e) {
      console.complain(text("errorIn", file.file(), CommandLanguage.shown(e.getMessage())));
      return ExitCode.UNAVAILABLE;
    }
  }

  private ExitCode run(
      RunnableFile file, Controller controller, RenderOptions options, Console console)
      throws UsageException {
    if (file.source().isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    Source source = file.source().get();
    LoadResult loadResult = controller.load(source);
    Report.diagnostics(source, loadResult.diagnostics()).forEach(console::complainInLines);
    file.wrongInReceived(loadResult.diagnostics()).forEach(console::complainFromEnglish);
    if (loadResult.program().isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    // Before the program runs: without graphics there is no use in that.
    Optional<PictureRenderer.Factory> renderers = services.renderers().get();
    if (renderers.isEmpty()) {
      console.complain(text("cannotDraw"));
      return ExitCode.UNAVAILABLE;
    }
    try (PictureRenderer renderer = renderers.get().start();
        Interruption interruption = Interruption.listen("theRun");
        WallLimit wall = WallLimit.begin(options.run().wallTimeoutS(), file.file())) {
      interruption.hold();
      Exposure exposure = new Exposure(controller.state(), options.atS(), renderer);
      Program program = loadResult.program().get();
      ExitCode code =
          new HeadlessRun(file, controller, options.run(), interruption, wall, console, exposure)
              .run(program);
      if (exposure.tooEarly() && code == ExitCode.DONE) {
        console.complain(Report.note(source, text("endedBeforeAt")));
      }
      code = code.or(write(renderer, picture(exposure, controller, options), options, console));
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      return code;
    } catch (GraphicsUnavailable e) {
      console.complain("pendant render: " + CommandLanguage.shown(e.getMessage()));
      return ExitCode.UNAVAILABLE;
    }
  }

  private static Picture picture(Exposure exposure, Controller controller, RenderOptions options) {
    return new Picture(
        options.run().controller().robotId(),
        exposure.state().arm(),
        MovedScene.of(options.run().controller().scene(), exposure.state().moved()),
        options.run().controller().equipment().devices(),
        exposure.state().devices(),
        options.showSafety() ? Optional.of(controller.safety()) : Optional.empty(),
        exposure.state().safety(),
        options.view(),
        options.dark(),
        options.widthPx(),
        options.heightPx());
  }

  private static ExitCode write(
      PictureRenderer renderer, Picture picture, RenderOptions options, Console console) {
    try {
      options.out().write(out -> renderer.write(picture, out));
      return ExitCode.DONE;
    } catch (UsageException e) {
      console.complain("pendant render: " + CommandLanguage.shown(e.getMessage()));
      return ExitCode.WRONG_USAGE;
    }
  }
}
