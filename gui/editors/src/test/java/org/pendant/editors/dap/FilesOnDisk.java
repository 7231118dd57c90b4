package org.pendant.editors.dap;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.editors.dap.run.DebugTarget;
import org.pendant.editors.dap.run.DebugTargets;
import org.pendant.editors.dap.run.TargetRefusal;
import org.pendant.language.source.Source;
import org.pendant.text.Language;

/**
 * Programs for tests: scripts as they are in a folder; {@code --tree} takes one for that of a tree.
 */
final class FilesOnDisk implements DebugTargets {
  @Override
  public DebugTarget target(String program, List<String> options, Language language)
      throws TargetRefusal {
    if (options.contains("--robot=ur99")) {
      throw new TargetRefusal("--robot is ur99, did you mean ur5?");
    }
    try {
      Source source = Source.of(program, Files.readAllBytes(Path.of(program)));
      boolean tree = options.contains("--tree");
      return new DebugTarget(
          program,
          Optional.of(tree ? Source.of("tree.script", source.bytes()) : source),
          tree,
          line -> tree ? Optional.of("tree.pendant: node " + line + ": ") : Optional.empty(),
          List.of(),
          List.of(),
          ControllerOptions.headless(),
          InputWaveforms.NONE,
          VirtualClock::new,
          () -> {},
          Optional.empty());
    } catch (IOException e) {
      throw new TargetRefusal(program + ": there is no such file");
    }
  }
}
