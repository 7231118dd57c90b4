package org.pendant.recording;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.script.function.ScriptPlace;

/** Forms of messages to people. */
final class MessageForms {
  private static final Form<Optional<ScriptPlace>> PLACE =
      new Form<ScriptPlace>() {
        @Override
        void write(ScriptPlace value, ByteSink out) {
          out.text(value.source());
          out.whole(value.thread());
          out.text(value.threadName());
          out.whole(value.line());
        }

        @Override
        ScriptPlace read(ByteSource in) throws MalformedBytes {
          return new ScriptPlace(in.text(), in.integer(), in.text(), in.integer());
        }
      }.optional();

  private static final Form<List<LogEntry>> ENTRIES =
      new Form<LogEntry>() {
        @Override
        void write(LogEntry value, ByteSink out) {
          out.whole(value.number());
          out.number(value.timeS());
          out.constant(value.level());
          out.constant(value.origin());
          out.text(value.code());
          out.text(value.text());
          PLACE.write(value.place(), out);
        }

        @Override
        LogEntry read(ByteSource in) throws MalformedBytes {
          return new LogEntry(
              in.whole(),
              in.number(),
              in.constant(LogEntry.Level.class),
              in.constant(LogEntry.Origin.class),
              in.text(),
              in.text(),
              PLACE.read(in));
        }
      }.list();

  static final Form<List<Popup>> POPUPS =
      new Form<Popup>() {
        @Override
        void write(Popup value, ByteSink out) {
          out.whole(value.number());
          out.number(value.timeS());
          out.text(value.title());
          out.text(value.text());
          out.constant(value.severity());
          out.bool(value.blocking());
        }

        @Override
        Popup read(ByteSource in) throws MalformedBytes {
          return new Popup(
              in.whole(),
              in.number(),
              in.text(),
              in.text(),
              in.constant(Popup.Severity.class),
              in.bool());
        }
      }.list();

  static final Form<List<Question>> QUESTIONS =
      new Form<Question>() {
        @Override
        void write(Question value, ByteSink out) {
          out.whole(value.number());
          out.number(value.timeS());
          out.constant(value.kind());
          out.text(value.text());
        }

        @Override
        Question read(ByteSource in) throws MalformedBytes {
          return new Question(in.whole(), in.number(), in.constant(Question.Kind.class), in.text());
        }
      }.list();

  static final Form<FrameDelta> NEWS =
      new Form<>() {
        @Override
        void write(FrameDelta value, ByteSink out) {
          ENTRIES.write(value.entries(), out);
          POPUPS.write(value.popups(), out);
          QUESTIONS.write(value.questions(), out);
          ProgramForms.EVENTS.write(value.events(), out);
          out.whole(value.newestEntry());
        }

        @Override
        FrameDelta read(ByteSource in) throws MalformedBytes {
          return new FrameDelta(
              ENTRIES.read(in),
              POPUPS.read(in),
              QUESTIONS.read(in),
              ProgramForms.EVENTS.read(in),
              in.whole());
        }
      };

  private MessageForms() {}
}
