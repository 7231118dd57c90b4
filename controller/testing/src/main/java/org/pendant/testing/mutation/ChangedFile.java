package org.pendant.testing.mutation;

import java.io.IOException;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;
import org.pendant.language.source.Source;
import org.pendant.testing.source.TestSources;

/** Changed file: files of which one has a mutation in it. */
final class ChangedFile implements TestSources {
  private final TestSources files;
  private final Source source;
  private final Mutation mutation;

  ChangedFile(TestSources files, Source source, Mutation mutation) {
    this.files = files;
    this.source = source;
    this.mutation = mutation;
  }

  @Override
  public byte[] read(String name) throws IOException {
    return name.equals(source.name()) ? mutation.in(source) : files.read(name);
  }

  @Override
  public ControllerOptions setUp(ControllerOptions base, Installation own, Optional<String> robot)
      throws IOException {
    return files.setUp(base, own, robot);
  }

  @Override
  public ProgramsFolder folder(String name) {
    return files.folder(name);
  }
}
