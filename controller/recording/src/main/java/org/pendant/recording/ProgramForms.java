package org.pendant.recording;

import static org.pendant.recording.RecordingTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.RuntimeState;
import org.pendant.language.source.SourceRange;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.PauseReason;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramLabel;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;
import org.pendant.script.vm.ThreadSnapshot;

/** Forms of what programs do. */
final class ProgramForms {
  private static final Form<SourceRange> RANGE =
      new Form<>() {
        @Override
        void write(SourceRange value, ByteSink out) {
          out.whole(value.start());
          out.whole(value.end());
        }

        @Override
        SourceRange read(ByteSource in) throws MalformedBytes {
          return new SourceRange(in.integer(), in.integer());
        }
      };

  private static final Form<ScriptFailure.StackEntry> STACK_ENTRY =
      new Form<>() {
        @Override
        void write(ScriptFailure.StackEntry value, ByteSink out) {
          out.text(value.function());
          out.whole(value.line());
        }

        @Override
        ScriptFailure.StackEntry read(ByteSource in) throws MalformedBytes {
          return new ScriptFailure.StackEntry(in.text(), in.integer());
        }
      };

  private static final Form<List<ScriptFailure.StackEntry>> STACK = STACK_ENTRY.list();

  private static final Form<ScriptFailure> FAILURE =
      new Form<>() {
        @Override
        void write(ScriptFailure value, ByteSink out) {
          out.text(value.code());
          out.text(value.message());
          RANGE.write(value.range(), out);
          out.whole(value.line());
          out.whole(value.column());
          STACK.write(value.stack(), out);
        }

        @Override
        ScriptFailure read(ByteSource in) throws MalformedBytes {
          return new ScriptFailure(
              in.text(), in.text(), RANGE.read(in), in.integer(), in.integer(), STACK.read(in));
        }
      };

  private static final Form<Ending> ENDING =
      new Form<>() {
        @Override
        void write(Ending value, ByteSink out) {
          switch (value) {
            case Ending.Finished finished -> out.byteOf(0);
            case Ending.Halted halted -> out.byteOf(1);
            case Ending.Stopped stopped -> out.byteOf(2);
            case Ending.Failed failed -> {
              out.byteOf(3);
              FAILURE.write(failed.failure(), out);
            }
          }
        }

        @Override
        Ending read(ByteSource in) throws MalformedBytes {
          return switch (in.upTo(3)) {
            case 0 -> new Ending.Finished();
            case 1 -> new Ending.Halted();
            case 2 -> new Ending.Stopped();
            default -> new Ending.Failed(FAILURE.read(in));
          };
        }
      };

  private static final Form<Optional<Ending>> SOME_ENDING = ENDING.optional();

  static final Form<ProgramStatus> STATUS =
      new Form<>() {
        @Override
        void write(ProgramStatus value, ByteSink out) {
          out.constant(value.state());
          out.constant(value.runtime());
          out.text(value.name());
          out.whole(value.line());
          SOME_ENDING.write(value.ending(), out);
        }

        @Override
        ProgramStatus read(ByteSource in) throws MalformedBytes {
          return new ProgramStatus(
              in.constant(ProgramState.class),
              in.constant(RuntimeState.class),
              in.text(),
              in.integer(),
              SOME_ENDING.read(in));
        }
      };

  private static final Form<PauseReason> REASON =
      new Form<>() {
        @Override
        void write(PauseReason value, ByteSink out) {
          switch (value) {
            case PauseReason.AtBreakpoint at -> {
              out.byteOf(0);
              out.whole(at.line());
              out.whole(at.hits());
            }
            case PauseReason.ConditionFailed failed -> {
              out.byteOf(1);
              out.whole(failed.line());
              out.text(failed.message());
            }
            case PauseReason.Stepped stepped -> out.byteOf(2);
            case PauseReason.PauseRequested requested -> out.byteOf(3);
            case PauseReason.Failed failed -> {
              out.byteOf(4);
              FAILURE.write(failed.failure(), out);
            }
          }
        }

        @Override
        PauseReason read(ByteSource in) throws MalformedBytes {
          return switch (in.upTo(4)) {
            case 0 -> new PauseReason.AtBreakpoint(in.integer(), in.whole());
            case 1 -> new PauseReason.ConditionFailed(in.integer(), in.text());
            case 2 -> new PauseReason.Stepped();
            case 3 -> new PauseReason.PauseRequested();
            default -> new PauseReason.Failed(FAILURE.read(in));
          };
        }
      };

  private static final Form<Optional<DebugState.Stop>> STOP =
      new Form<DebugState.Stop>() {
        @Override
        void write(DebugState.Stop value, ByteSink out) {
          out.whole(value.number());
          REASON.write(value.reason(), out);
          out.whole(value.thread());
          out.whole(value.line());
        }

        @Override
        DebugState.Stop read(ByteSource in) throws MalformedBytes {
          return new DebugState.Stop(in.whole(), REASON.read(in), in.integer(), in.integer());
        }
      }.optional();

  private static final Form<List<ThreadSnapshot.Level>> LEVELS =
      new Form<ThreadSnapshot.Level>() {
        @Override
        void write(ThreadSnapshot.Level value, ByteSink out) {
          out.text(value.function());
          out.text(value.source());
          out.whole(value.line());
          RANGE.write(value.range(), out);
        }

        @Override
        ThreadSnapshot.Level read(ByteSource in) throws MalformedBytes {
          return new ThreadSnapshot.Level(in.text(), in.text(), in.integer(), RANGE.read(in));
        }
      }.list();

  private static final Form<List<ThreadSnapshot>> THREADS =
      new Form<ThreadSnapshot>() {
        @Override
        void write(ThreadSnapshot value, ByteSink out) {
          out.whole(value.id());
          out.text(value.name());
          out.text(value.waitsFor());
          LEVELS.write(value.stack(), out);
        }

        @Override
        ThreadSnapshot read(ByteSource in) throws MalformedBytes {
          int id = in.integer();
          String name = in.text();
          String waitsFor = in.text();
          List<ThreadSnapshot.Level> stack = LEVELS.read(in);
          if (stack.isEmpty()) {
            throw new MalformedBytes(text("threadWithoutCalls", id));
          }
          return new ThreadSnapshot(id, name, waitsFor, stack);
        }
      }.list();

  static final Form<DebugState> DEBUG =
      new Form<>() {
        @Override
        void write(DebugState value, ByteSink out) {
          STOP.write(value.stop(), out);
          THREADS.write(value.threads(), out);
        }

        @Override
        DebugState read(ByteSource in) throws MalformedBytes {
          return new DebugState(STOP.read(in), THREADS.read(in));
        }
      };

  private static final Form<List<ProgramLabel>> LABELS =
      new Form<ProgramLabel>() {
        @Override
        void write(ProgramLabel value, ByteSink out) {
          out.whole(value.line());
          out.whole(value.number());
          out.text(value.text());
        }

        @Override
        ProgramLabel read(ByteSource in) throws MalformedBytes {
          return new ProgramLabel(in.integer(), in.integer(), in.text());
        }
      }.list();

  static final Form<List<ProgramEvent>> EVENTS =
      new Form<ProgramEvent>() {
        @Override
        void write(ProgramEvent value, ByteSink out) {
          switch (value) {
            case ProgramEvent.Started started -> {
              out.byteOf(0);
              LABELS.write(started.labels(), out);
            }
            case ProgramEvent.Ended ended -> {
              out.byteOf(1);
              ENDING.write(ended.ending(), out);
            }
            case ProgramEvent.SecondaryFailed failed -> {
              out.byteOf(2);
              FAILURE.write(failed.failure(), out);
            }
          }
          out.text(value.name());
        }

        @Override
        ProgramEvent read(ByteSource in) throws MalformedBytes {
          return switch (in.upTo(2)) {
            case 0 -> {
              List<ProgramLabel> labels = LABELS.read(in);
              yield new ProgramEvent.Started(in.text(), labels);
            }
            case 1 -> {
              Ending ending = ENDING.read(in);
              yield new ProgramEvent.Ended(in.text(), ending);
            }
            default -> {
              ScriptFailure failure = FAILURE.read(in);
              yield new ProgramEvent.SecondaryFailed(in.text(), failure);
            }
          };
        }
      }.list();

  private ProgramForms() {}
}
