package org.pendant.recording.replay;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.command.Command;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.MeshFiles;
import org.pendant.language.source.Source;
import org.pendant.models.json.JsonException;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** A cell, the commands that its controllers get in which frame, and what comes of them in each. */
public final class CellPlay {
  private final SwitchOn switchOn;
  private final RunJournal journal;
  private final Map<Long, List<Left>> scheduled = new TreeMap<>();

  /** What each frame brought to each controller, that of frame 1 first. */
  private final List<List<Object>> frames = new ArrayList<>();

  private record Left(int member, Command command) {}

  /** A cell of the arms and all else of {@code scene}, each controller with the same options. */
  public CellPlay(String scene, ControllerOptions each) {
    try {
      byte[] file = scene.getBytes(StandardCharsets.UTF_8);
      CellPlan plan = CellPlan.read("cell.json", new ByteArrayInputStream(file), MeshFiles.NONE);
      List<ControllerOptions> options = new ArrayList<>();
      plan.layout().names().forEach(_ -> options.add(each));
      Builtins<ControlBox> builtins = StandardBuiltins.create();
      switchOn = SwitchOn.of(plan, options, builtins);
      journal = RunJournal.of(Controllers.of(new Cell(plan, options, builtins)));
    } catch (JsonException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /** How the cell was switched on. */
  public SwitchOn switchOn() {
    return switchOn;
  }

  /** What its controllers got. */
  public RunJournal journal() {
    return journal;
  }

  /** One of the controllers. */
  public Controller controller(int member) {
    return journal.controllers().all().get(member);
  }

  /** A program for one of the controllers. */
  public Program program(int member, String text) {
    LoadResult loaded =
        controller(member)
            .load(Source.of("play.script", text.getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loaded.program().isPresent(), () -> loaded.diagnostics().toString());
    return loaded.program().get();
  }

  /** Has a command left for a controller right before a frame. */
  public CellPlay at(long frame, int member, Command command) {
    scheduled.computeIfAbsent(frame, _ -> new ArrayList<>()).add(new Left(member, command));
    return this;
  }

  /** Has a program started in a frame. */
  public CellPlay start(long frame, int member, String text) {
    return at(frame, member, new ProgramCommand.StartProgram(program(member, text)));
  }

  /** Runs up to the end of a frame. */
  public CellPlay until(long frame) {
    frames.addAll(follow(journal.controllers(), frame));
    return this;
  }

  /** Does the same to others from where they stand; answers what each frame brought. */
  List<List<Object>> follow(Controllers others, long last) {
    List<List<Object>> brought = new ArrayList<>();
    while (others.frame() < last) {
      for (Left each : scheduled.getOrDefault(others.frame() + 1, List.of())) {
        var _ = others.all().get(each.member()).submit(each.command());
      }
      others.frames().advance();
      brought.add(facts(others));
    }
    return brought;
  }

  /** What frames brought, from the one after {@code before} to {@code last}. */
  List<List<Object>> frames(long before, long last) {
    return frames.subList((int) before, (int) last);
  }

  /** Controllers that were switched on as those of this cell were. */
  Controllers fresh() {
    return switchOn.with(journal.controllers().all().stream().map(_ -> Connectors.NONE).toList());
  }

  /** Repeats the run up to the end of a frame. */
  RunJournal again(long frame) throws RerunRefused {
    return Rerun.to(frame, journal).run(fresh(), () -> {});
  }

  /** All that is a number, a text or made of such in the snapshots of all controllers. */
  static List<Object> facts(Controllers of) {
    List<Object> facts = new ArrayList<>();
    of.all().forEach(each -> facts.add(Play.facts(each.state())));
    return facts;
  }

  /** The snapshot of each controller, as a recording has them. */
  static List<Optional<ControllerState>> recorded(Controllers of) {
    return of.all().stream().map(each -> Optional.of(each.state())).toList();
  }
}
