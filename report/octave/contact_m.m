%Contact.m
%Program to numercally calculate contact area and pressure distribution between two cylinders
%03/28/2001
%
%The listing of Ruggiero (2001), Appendix 3, pp. 17-19, as printed. Restored, since print or its conversion to text
%lost them:
%  - the minus before 2*x^2 in g and in f, where a line ended;
%  - the small letter of "else" after B(i,j)=0, printed "Else", which is no keyword.
%Changed: -ascii, printed -ASCII, is in small letters, since Octave minds the case.
%Everything else stands as it is printed, its defects too.
clear;
P=2500;                         %Force (lb/inch)
c=.0005;                        %Element size (inch)
EE=30000000;                    %Modulus of Elasticity (psi)
v=.30;                          %Poissons's ratio
R1=1;                           %Radius of cylinder 1 (inch)
R2=3;                           %Radius of cylinder 2 (inch)
n=37;                           %Number of nodes
nn=n-1;                         %n-1 nodes
z=1;                            %zero intersection
aa=9;                           %Node where p becomes zero
E=1/(2*(1-v^2)/EE);
R=1/(1/R1+1/R2);
%Calculates triangular element constant
g=inline('(1-v^2)/(2*pi*EE*c)*((x+c)^2*log(((x+c)/c)^2)+(x-c)^2*log(((x-c)/c)^2)-2*x^2*log((x/c)^2))','x','v','EE','c');
const=-g(z,v,EE,c);
%Calculates influence coefficients
for i = 1:nn                    %i=1 refers to i=0
  for j = 1:nn
    k=i-j;
    x=k*c;
    if x < -z
      x=-z;
    elseif x == -c
      x=-c+.0000001;
    elseif x == 0
      x=.0000001;
    elseif x == c
      x=c+.0000001;
    elseif x > z
      x=z;
    else
    end
    f=inline('-(1-v^2)/(2*pi*EE*c)*((x+c)^2*log(((x+c)/c)^2)+(x-c)^2*log(((x-c)/c)^2)-2*x^2*log((x/c)^2))+const','x','v','EE','c','const');
    ff(i)=f(x,v,EE,c,const);
    C(i,j)=f(x,v,EE,c,const);
    B(i,j)=C(1,j)-C(i,j);
  end
  h(i,:)=.5*(1/R)*((i-1)*c)^2;
end
%Sets pi=0 for negative pressures
for i =aa:nn
  for j = 1:nn
    if j ~= i
      B(i,j)=0;
    else
      h(i)=0;
    end
  end
end
%Calculates last equation
A=c*(aa-2)                      %Contact area
h(1)=P;
for j = 1:nn
  B(1,j)=A;
end
p=B\h;                          %Pressure distribution
save Numer.out p -ascii
%Solution using Hertz method
a=sqrt(4*2*P*R/(pi*E));         %Contact width
p0=2*2*P/(pi*a);                %Maximum pressure
i=1;
x=0;
while x < (a-c)
  x(i)=i*c;
  p_h(i)=2*2*P/(pi*a^2)*(a^2-(x(i))^2)^(.5); %Pressure distribution
  i=i+1;
end
for j = i:(n-1)
  p_h(j)=0;
end
pp=p_h';
figure(1)
subplot(2,2,1)
xx = 1:(n-1);
plot(xx,p,xx,pp);
