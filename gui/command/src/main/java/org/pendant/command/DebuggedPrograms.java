package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.DebugTargets;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.protocols.ScriptConnectors;
import org.pendant.protocols.externalcontrol.NoScript;
import org.pendant.testing.run.DebuggedTest;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestRunner;
import org.pendant.text.Language;

/**
 * Debugged programs: what an editor debugs, with the options of {@code pendant run}. What is wrong
 * is told in the language of the editor, whichever the command itself speaks.
 */
final class DebuggedPrograms implements DebugTargets {
  @Override
  public DebugTarget target(String program, List<String> options, Language language)
      throws TargetRefusal {
    return CommandLanguage.spoken(language, () -> target(program, options));
  }

  private static DebugTarget target(String program, List<String> options) throws TargetRefusal {
    try {
      Arguments arguments = Arguments.parse(RunOptions.OF_DEBUGGING, options);
      if (!arguments.operands().isEmpty()) {
        throw new TargetRefusal(text("argsNoOption", arguments.operands().getFirst()));
      }
      CellFile.refuse(arguments);
      RunnableFile read = RunnableFile.read(arguments, List.of(program)).getFirst();
      RunOptions asked = RunOptions.of(arguments, read.installation(), read.robot());
      RunnableFile whole = read.asked(asked.drivers());
      ScriptConnectors connectors = new ScriptConnectors(asked.hosts());
      return new DebugTarget(
          program,
          whole.source(),
          whole.tree().isPresent(),
          whole::nodeAt,
          whole.notes(),
          whole.problems(),
          asked.controller().withOutside(connectors.connectors()),
          asked.waveforms(),
          asked::clock,
          connectors::close,
          Optional.empty());
    } catch (UsageException | NoScript e) {
      throw new TargetRefusal(String.valueOf(e.getMessage()));
    }
  }

  @Override
  public DebugTarget test(String file, String test, List<String> options, Language language)
      throws TargetRefusal {
    return CommandLanguage.spoken(language, () -> test(file, test, options));
  }

  private static DebugTarget test(String file, String test, List<String> options)
      throws TargetRefusal {
    try {
      Arguments arguments = Arguments.parse(TestOptions.ALL, options);
      if (!arguments.operands().isEmpty()) {
        throw new TargetRefusal(text("argsNoOption", arguments.operands().getFirst()));
      }
      TestFilesOnDisk disk = new TestFilesOnDisk(arguments);
      TestRunner runner =
          new TestRunner(
              disk,
              TestOptions.of(arguments).settings(),
              each -> each.id().name().equals(test),
              result -> {},
              Goldens.NONE,
              Optional.empty());
      TestPlan plan = runner.plan(List.of(file));
      if (!plan.broken().isEmpty()) {
        throw new TargetRefusal(plan.broken().getFirst().problems().getFirst());
      }
      if (plan.tests().isEmpty()) {
        throw new TargetRefusal(text("noSuchTest", test, file));
      }
      return DebugTarget.of(file, runner.debug(plan, plan.tests().getFirst().id()));
    } catch (UsageException | DebuggedTest.NotDebugged e) {
      throw new TargetRefusal(String.valueOf(e.getMessage()));
    }
  }
}
