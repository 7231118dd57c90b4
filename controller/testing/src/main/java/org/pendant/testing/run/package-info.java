/** Running tests: one in a controller of its own, or all that are found, several at once. */
package org.pendant.testing.run;
