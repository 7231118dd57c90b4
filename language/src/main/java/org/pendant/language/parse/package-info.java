/**
 * Parser: from script text to the syntax tree: {@link org.pendant.language.parse.ScriptParser}
 * reads a file or a single interpreter-mode line and reports every syntax error in it at once. Open
 * ScriptParser first; it names the passes in their order.
 */
package org.pendant.language.parse;
