package org.pendant.language.parse;

import java.util.List;

/**
 * What was read of a text.
 *
 * @param lexemes of the whole text in order; the list is the receiver's own
 */
public record ReadText(ParseResult result, List<Lexeme> lexemes) {}
