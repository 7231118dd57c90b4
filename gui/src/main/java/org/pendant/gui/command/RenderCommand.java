package org.pendant.gui.command;

import java.awt.image.BufferedImage;
import java.util.List;
import javax.imageio.ImageIO;
import org.pendant.controller.Controller;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.world.Scene;
import org.pendant.gui.scene.Camera;
import org.pendant.gui.scene.Outline;
import org.pendant.gui.scene.SceneModel;
import org.pendant.gui.scene.Touching;
import org.pendant.gui.scene.gl.OffscreenScene;
import org.pendant.gui.scene.gl.SceneUnavailable;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** {@code pendant render FILE}: runs a program and draws the arm at one moment. */
final class RenderCommand implements Subcommand {

  @Override
  public String name() {
    return "render";
  }

  @Override
  public String operands() {
    return "FILE";
  }

  @Override
  public String summary() {
    return "run a program and draw the arm, at its end or at a time";
  }

  @Override
  public List<Option> options() {
    return RenderOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (arguments.operands().size() != 1) {
      throw new UsageException("expected one file, there are " + arguments.operands().size());
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
      console.complain(file.file() + ": error: " + e.getMessage());
      return ExitCode.UNAVAILABLE;
    }
  }

  private static ExitCode run(
      RunnableFile file, Controller controller, RenderOptions options, Console console)
      throws UsageException {
    if (file.source().isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    Source source = file.source().get();
    LoadResult loadResult = controller.load(source);
    Report.diagnostics(source, loadResult.diagnostics()).forEach(console::complainInLines);
    file.wrongInReceived(loadResult.diagnostics()).forEach(console::complain);
    if (loadResult.program().isEmpty()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    // Before the program runs: without graphics there is no use in that.
    try (OffscreenScene scene = OffscreenScene.open();
        Interruption interruption = Interruption.listen("the run");
        WallLimit wall = WallLimit.begin(options.run().wallTimeoutS(), file.file())) {
      interruption.hold();
      Exposure exposure = new Exposure(controller.state(), options.atS());
      Program program = loadResult.program().get();
      ExitCode code =
          new HeadlessRun(file, controller, options.run(), interruption, wall, console, exposure)
              .run(program);
      if (exposure.tooEarly() && code == ExitCode.DONE) {
        console.complain(Report.note(source, "ended before --at; the picture shows its end"));
      }
      code = code.or(write(picture(scene, exposure, options), options, console));
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      return code;
    } catch (SceneUnavailable e) {
      console.complain("pendant render: " + e.getMessage());
      return ExitCode.UNAVAILABLE;
    }
  }

  private static BufferedImage picture(
      OffscreenScene scene, Exposure exposure, RenderOptions options) {
    ArmState arm = exposure.state().arm();
    Scene world = options.run().controller().scene();
    SceneModel model =
        SceneModel.of(
                ArmLibrary.load(options.run().controller().robotId()), arm.actualPositionRad())
            .at(arm)
            .withWorld(
                world,
                new Touching(world)
                    .names(arm.kinematics(), arm.actualPositionRad(), arm.tool().inFlange()))
            .withTrace(exposure.trace())
            .withTheme(options.theme());
    double aspect = (double) options.widthPx() / options.heightPx();
    Camera camera = Camera.of(options.view(), Outline.of(model), aspect);
    return scene.render(model, camera, options.widthPx(), options.heightPx());
  }

  private static ExitCode write(BufferedImage picture, RenderOptions options, Console console) {
    // A picture in the making needs no file besides its own.
    ImageIO.setUseCache(false);
    try {
      options.out().write(out -> ImageIO.write(picture, "png", out));
      return ExitCode.DONE;
    } catch (UsageException e) {
      console.complain("pendant render: " + e.getMessage());
      return ExitCode.WRONG_USAGE;
    }
  }
}
