/**
 * Built-in functions as the machine sees them: a declaration, one call of it, and what it answers.
 * Open {@link org.pendant.script.function.Builtins} first, then {@link
 * org.pendant.script.function.Call}.
 */
package org.pendant.script.function;
