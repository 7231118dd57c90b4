package org.pendant.desktop.editor;

import java.util.Optional;
import org.pendant.desktop.session.ProgramDocument;

/** Text memory: knows where people were in texts that they open again. */
public interface TextMemory {
  /** Knows nothing. */
  TextMemory NONE =
      new TextMemory() {
        @Override
        public Optional<TextPlace> of(ProgramDocument program) {
          return Optional.empty();
        }

        @Override
        public void closing(ProgramDocument program, TextPlace place) {}
      };

  /** Where people were when {@code program} was open last. */
  Optional<TextPlace> of(ProgramDocument program);

  /** {@code program} is about to be closed at this place. */
  void closing(ProgramDocument program, TextPlace place);
}
