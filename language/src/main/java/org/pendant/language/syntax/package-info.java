/**
 * The syntax tree of URScript: sealed interfaces with records inside, every node with its exact
 * source range. Open {@link org.pendant.language.syntax.Script} first, then {@link
 * org.pendant.language.syntax.Statement} and {@link org.pendant.language.syntax.Expression}.
 */
package org.pendant.language.syntax;
