package org.pendant.testing.mutation;

import java.io.IOException;
import org.pendant.controller.file.ProgramsFolder;
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
  public ProgramsFolder folder(String name) {
    return files.folder(name);
  }
}
