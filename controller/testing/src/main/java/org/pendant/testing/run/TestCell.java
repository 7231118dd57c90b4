package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Reply;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.layout.ArmEntry;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.models.json.JsonException;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.testing.source.TestScene;

/**
 * Cell of a test: the test runs on the controller of the first arm; the others run what the scene
 * names, from the start of the test.
 */
final class TestCell {
  private final Cell cell;

  /** What each controller runs by itself; the first one nothing. */
  private final List<Optional<Program>> programs;

  private final List<CompletableFuture<Reply>> started = new ArrayList<>();

  private TestCell(Cell cell, List<Optional<Program>> programs) {
    this.cell = cell;
    this.programs = programs;
  }

  /**
   * Switches the controllers on.
   *
   * @param scene with several controllers
   * @param first how that of the first arm is switched on
   * @throws IOException if the cell cannot be as its file says; the message says why, for people
   */
  static TestCell of(
      TestScene scene,
      TestPrograms programs,
      ControllerOptions first,
      Builtins<ControlBox> builtins)
      throws IOException {
    CellPlan plan = scene.plan();
    List<ControllerOptions> options = new ArrayList<>();
    List<Optional<Program>> running = new ArrayList<>();
    for (ArmEntry arm : plan.arms()) {
      ControllerOptions own = options.isEmpty() ? first : other(first, options.size());
      boolean tested = options.isEmpty();
      options.add(programs.setUp(arm, scene.name(), own));
      running.add(
          tested || arm.program().isEmpty()
              ? Optional.empty()
              : Optional.of(programs.ofArm(scene.name(), arm.program().get())));
    }
    if (plan.layout().script().isPresent()) {
      options.add(other(first, options.size()));
      running.add(Optional.of(programs.ofCell(scene.name(), plan.layout().script().get())));
    }
    try {
      return new TestCell(new Cell(plan, options, builtins), running);
    } catch (JsonException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static ControllerOptions other(ControllerOptions first, int number) {
    return first.withSeed(first.seed() + number).withOutside(Connectors.NONE);
  }

  /** All controllers; the test runs on the first one. */
  Cell cell() {
    return cell;
  }

  /** The controller of the first arm. */
  Controller tested() {
    return cell.members().getFirst().controller();
  }

  /** Has the others begin in the next frame. */
  void begin(TestPrograms files) {
    for (int i = 0; i < programs.size(); i++) {
      if (programs.get(i).isPresent()) {
        Program program = programs.get(i).get();
        started.add(
            cell.members()
                .get(i)
                .controller()
                .submit(
                    new ProgramCommand.StartProgram(program, Optional.of(files.folder(program)))));
      }
    }
  }

  /** Runs one frame of all. */
  void advance() {
    cell.advance();
  }

  /** Why one of the others does not do any more what it should; empty while all do. */
  Optional<String> trouble() {
    for (Cell.Member member : cell.members().subList(1, programs.size())) {
      ControllerState state = member.controller().state();
      Optional<SafetyStop> stop = state.safety().stop();
      if (stop.isPresent()) {
        return Optional.of(member.name() + ": " + stop.get().message());
      }
      if (state.program().ending().orElse(null) instanceof Ending.Failed(var why)) {
        return Optional.of(
            text("memberFailed", member.name(), why.line(), ByteText.decoded(why.message())));
      }
    }
    return started.stream()
        .filter(CompletableFuture::isDone)
        .flatMap(each -> each.join().complaint().stream())
        .findFirst();
  }
}
