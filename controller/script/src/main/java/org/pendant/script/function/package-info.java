/**
 * What a built-in function is to the machine: its declaration, one call of it, and what it answers.
 * Open {@link org.pendant.script.function.Builtins} first, then {@link
 * org.pendant.script.function.Call}.
 */
package org.pendant.script.function;
