package org.pendant.desktop.timeline;

import java.util.function.Consumer;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.RecordingRing;
import org.pendant.script.debug.Debugger;

/** A controller that is recorded. */
final class RecordedRun {
  private final Controller controller;
  final RecordingRing ring;

  RecordedRun() {
    this(ControllerOptions.headless());
  }

  RecordedRun(ControllerOptions options) {
    controller = new Controller(options);
    ring = new RecordingRing(controller.state(), controller::programSource);
  }

  RecordedRun start(String text) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, text)));
    return this;
  }

  RecordedRun frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
      ring.take(controller.state());
    }
    return this;
  }

  RecordedRun pause() {
    var _ = controller.submit(new ProgramCommand.PauseProgram());
    return this;
  }

  RecordedRun resume() {
    var _ = controller.submit(new ProgramCommand.ResumeProgram());
    return this;
  }

  /** Asks the debugger in the next frame. */
  RecordedRun ask(Consumer<Debugger> request) {
    var _ = controller.submit(new DebugCommand.Debug(request));
    return frames(1);
  }

  ControllerState state() {
    return controller.state();
  }
}
