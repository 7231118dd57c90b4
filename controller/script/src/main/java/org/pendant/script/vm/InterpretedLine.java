package org.pendant.script.vm;

import java.nio.charset.StandardCharsets;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Source;

/**
 * Interpreted line: a line for interpreter mode, read but not yet checked against a program.
 * Reading is the larger part of the work, so the sender of a line does it in a thread of its own.
 *
 * @param text its bytes, one {@code char} each, without the line end
 * @param parsed what it says
 */
public record InterpretedLine(String text, ParseResult parsed) {
  /** Reads {@code text}; any thread. */
  public static InterpretedLine read(String text) {
    Source source = Source.of("interpreter", text.getBytes(StandardCharsets.ISO_8859_1));
    return new InterpretedLine(text, ScriptParser.parseLine(source));
  }

  /** Whether it may clear what was interpreted before it. */
  boolean clears() {
    return text.contains("clear_interpreter");
  }
}
